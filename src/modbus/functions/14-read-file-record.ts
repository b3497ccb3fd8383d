import { layout, type Rule, type Seen, type Values } from '../field.ts';
import { groups } from '../fields/groups.ts';
import { bytesOfList, bytesOfRegisters, count, lengthOf, sumOf, u16 } from '../fields/number.ts';
import { registers } from '../fields/registers.ts';
import { defineFunction } from '../function-code.ts';
import { fileNumber, recordNumber, referenceType } from './file-record.ts';

const REQUEST_GROUP = 7;
const MOST_GROUPS = 35;
/** The PDU's 253 bytes less function code and data length. */
const MOST_REPLY = 251;

/** Each group of the reply has its length, the reference type and the registers (AP 6.14). */
const replyFits: Rule<readonly Values[]> = (requests) => {
  const got = requests.reduce((sum, { recordLength }) => sum + 2 + bytesOfRegisters(recordLength as number), 0);
  return got > MOST_REPLY
    ? { code: 'reply-too-long', severity: 'error', got: got + 2, most: MOST_REPLY + 2 }
    : undefined;
};

/** The specification's table starts at 07, its own example has 05, and one register needs 03 (AP 6.14). */
const TABLE_LEAST = 0x07;
const belowTable = (got: number) =>
  got >= 2 && got < TABLE_LEAST
    ? ({ code: 'count-table-differs', severity: 'note', got, least: TABLE_LEAST, most: 0xf5 } as const)
    : undefined;

/** The registers of each group, as they were asked for. */
const askedLengths = (request: Seen['request']): readonly number[] | undefined =>
  (request?.fields['subRequests'] as readonly Values[] | undefined)?.map(({ recordLength }) => Number(recordLength));

const sumOfGroups = (lengths: readonly number[]) =>
  lengths.reduce((sum, length) => sum + 2 + bytesOfRegisters(length), 0);

/** The reply has the length of all groups that were asked for (AP 6.14). */
const lengthAsAsked: Rule<number> = (got, { request }) => {
  const asked = askedLengths(request);
  if (asked === undefined || got === sumOfGroups(asked)) return undefined;
  return { code: 'count-not-as-requested', severity: 'error', got, expected: sumOfGroups(asked) };
};

/** Each group has as many registers as were asked for. */
const groupsAsAsked: Rule<readonly Values[]> = (groups, { request, count }) => {
  const asked = askedLengths(request);
  // A length that differs in all is said of the length.
  if (asked === undefined || count !== sumOfGroups(asked)) return undefined;
  const at = asked.findIndex((length, i) => bytesOfList(groups[i]?.['recordData']) !== bytesOfRegisters(length));
  if (at < 0) return undefined;
  const got = bytesOfList(groups[at]?.['recordData']);
  return { code: 'count-not-as-requested', severity: 'error', got, expected: bytesOfRegisters(asked[at] ?? 0) };
};

export const readFileRecord = defineFunction({
  code: 0x14,
  name: 'Read File Record',
  section: 'AP 6.14',
  group: 'files',
  table: 'file-record',
  items: 'other',
  access: 'reads',
  probe: { subRequests: [{ referenceType: 6, fileNumber: 1, recordNumber: 0, recordLength: 1 }] },
  request: layout([
    count('byteCount', {
      least: REQUEST_GROUP,
      most: REQUEST_GROUP * MOST_GROUPS,
      derive: lengthOf('subRequests', (requests) => REQUEST_GROUP * requests),
    }),
    groups('subRequests', [referenceType, fileNumber, recordNumber, u16('recordLength')], {
      size: ({ count }) => count,
      rules: [replyFits],
    }),
  ]),
  response: layout([
    count('responseDataLength', {
      least: 2,
      most: MOST_REPLY,
      derive: sumOf('subResponses', ({ recordData }) => 2 + bytesOfList(recordData)),
      rules: [belowTable],
      replyRules: [lengthAsAsked],
    }),
    groups(
      'subResponses',
      [
        count('fileResponseLength', {
          least: 1,
          most: MOST_REPLY - 1,
          derive: lengthOf('recordData', (records) => 1 + bytesOfRegisters(records)),
        }),
        referenceType,
        registers('recordData', ({ count }) => count - 1),
      ],
      { size: ({ count }) => count, rules: [groupsAsAsked] },
    ),
  ]),
});
