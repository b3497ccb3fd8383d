import { layout, type Rule } from '../field.ts';
import { groups } from '../fields/groups.ts';
import { bytesOfList, bytesOfRegisters, count, echoes, lengthOf, sumOf, u16, within } from '../fields/number.ts';
import { registers } from '../fields/registers.ts';
import { defineFunction } from '../function-code.ts';
import { fileNumber, recordNumber, referenceType } from './file-record.ts';

/** Reference type, file number, record number and record length come before the records of each group. */
const BEFORE_RECORDS = 7;
/** A group with one register, and all that fits into the PDU (AP 6.15). */
const limits = { least: BEFORE_RECORDS + 2, most: 251 };

const dataLength = sumOf('subRequests', ({ recordData }) => BEFORE_RECORDS + bytesOfList(recordData));

/** The state diagram of AP 6.15 stops at F5, its field table at FB. */
const aboveDiagram: Rule<number> = (got) =>
  got > 0xf5 && got <= limits.most
    ? { code: 'count-table-differs', severity: 'note', got, least: 0x07, most: 0xf5 }
    : undefined;

const fields = layout([
  count('dataLength', { ...limits, derive: dataLength, rules: [aboveDiagram] }),
  groups(
    'subRequests',
    [
      referenceType,
      fileNumber,
      recordNumber,
      u16('recordLength', {
        kind: 'quantity',
        range: within(1, 122),
        derive: lengthOf('recordData'),
      }),
      registers('recordData', ({ items }) => bytesOfRegisters(items)),
    ],
    { size: ({ count }) => count, replyRules: [echoes('subRequests')] },
  ),
]);

export const writeFileRecord = defineFunction({
  code: 0x15,
  name: 'Write File Record',
  section: 'AP 6.15',
  group: 'files',
  table: 'file-record',
  items: 'other',
  access: 'writes',
  request: fields,
  response: fields,
});
