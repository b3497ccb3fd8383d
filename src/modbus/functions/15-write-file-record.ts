import { layout, type Rule, type Values } from '../field.ts';
import { groups } from '../fields/groups.ts';
import { bytesOfRegisters, count, echoes, lengthOf, stated, u16, within } from '../fields/number.ts';
import { registers } from '../fields/registers.ts';
import { defineFunction } from '../function-code.ts';
import { fileNumber, recordNumber, referenceType } from './file-record.ts';

/** Reference type, file number, record number and record length come before the records of each group. */
const BEFORE_RECORDS = 7;
/** A group with one register, and all that fits into the PDU (AP 6.15). */
const limits = { least: BEFORE_RECORDS + 2, most: 251 };

const dataLength = ({ subRequests }: Values): number | undefined =>
  Array.isArray(subRequests)
    ? subRequests.reduce(
        (sum: number, { recordData }) => sum + BEFORE_RECORDS + bytesOfRegisters(recordData?.length ?? 0),
        0,
      )
    : undefined;

/** The state diagram of AP 6.15 stops at F5, its field table at FB. */
const aboveDiagram: Rule<number> = (got) =>
  got > 0xf5 && got <= limits.most
    ? { code: 'count-table-differs', severity: 'note', got, least: 0x07, most: 0xf5 }
    : undefined;

const atLeastOne = { least: 1, most: 122 };

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
        range: atLeastOne,
        rules: [within(atLeastOne)],
        derive: lengthOf('recordData'),
      }),
      registers('recordData', (seen) => bytesOfRegisters(stated('recordLength', seen))),
    ],
    { size: (seen) => stated('dataLength', seen), rules: [echoes('subRequests')] },
  ),
]);

export const writeFileRecord = defineFunction({
  code: 0x15,
  name: 'Write File Record',
  section: 'AP 6.15',
  group: 'files',
  table: 'file-record',
  request: fields,
  response: fields,
});
