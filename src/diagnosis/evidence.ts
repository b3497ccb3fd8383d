import { codeRange, dictionary, exceptionCodes, LAST_UNIT, type Reading, TCP_DIRECT } from '../modbus/index.ts';

/** The bits that make a finding certain, or likely. */
export const CERTAIN = 20;
export const LIKELY = 14;

/** A CRC that holds. */
export const CRC_BITS = 16;
export const LRC_BITS = 8;
/** A frame that ends where the bytes do. */
const ENDS_BITS = 3;

/** The functions that make up nearly all traffic. */
const COMMON = new Set([1, 2, 3, 4, 5, 6, 15, 16]);
const KNOWN_EXCEPTIONS = new Set<number>(exceptionCodes.map(({ code }) => code));

/** The evidence of a legal value, in bits: how rare legal values are among all values of the field. */
const LEGAL_FIELD: Readonly<Record<string, number>> = dictionary({ quantity: 6, flag: 12, choice: 4, count: 1 });
const BROKEN_RULE = 9;
/** Problems that are weighed separately: of the frame's end, of its checksum, of its match with the request. */
const JUDGED_APART = new Set([
  'checksum-wrong',
  'frame-short',
  'frame-extra',
  'pdu-short',
  'pdu-rest',
  'count-wrong',
  'unit-not-as-requested',
  'function-not-as-requested',
  'transaction-not-as-requested',
  'broadcast-answered',
]);
/** The fields end before or after the end of the frame. */
const ENDS_ELSEWHERE = new Set(['pdu-short', 'pdu-rest', 'count-wrong']);
/** Whether a field has a value that it must not have; the end of the frame and its checksum aside. */
export const breaksRule = ({ problems }: Reading): boolean =>
  problems.some(({ code, severity }) => severity === 'error' && !JUDGED_APART.has(code));

/** Mismatches with the request, whose absence is evidence too. */
const AGAINST_REQUEST = { unit: 7, function: 7, count: 4 } as const;

/** log2 of a number of things tried. */
export const tries = (number: number): number => Math.log2(Math.max(1, number));

/** What a reading is compared with. */
export interface Asked {
  readonly unitId: number | undefined;
  readonly functionCode: number;
}

/**
 * How much better than chance the bytes fit a reading, in bits, checksum and length aside: a function and unit in
 * use, legal values, and a match with the request.
 */
export function likeness(reading: Reading, unitId: number | undefined, asked: Asked | undefined): number {
  const { functionCode } = reading;
  if (functionCode === undefined) return -3;
  let bits = functionBits(functionCode, reading) + unitBits(unitId, reading);
  for (const span of reading.spans) {
    const broken = reading.problems.some((problem) => problem.span === span && problem.severity !== 'note');
    if (!broken) bits += LEGAL_FIELD[span.kind] ?? 0;
  }
  for (const { code, severity } of reading.problems) {
    if (severity === 'error' && !JUDGED_APART.has(code)) bits -= BROKEN_RULE;
  }
  if (asked === undefined) return bits;
  if (asked.unitId !== undefined && unitId !== undefined) {
    bits += asked.unitId === unitId ? AGAINST_REQUEST.unit : -AGAINST_REQUEST.unit;
  }
  const same = (functionCode & 0x7f) === asked.functionCode;
  const counted = reading.spans.some(({ kind }) => kind === 'count');
  return bits + (same ? AGAINST_REQUEST.function + (counted ? AGAINST_REQUEST.count : 0) : -AGAINST_REQUEST.function);
}

function functionBits(functionCode: number, { direction, fields }: Reading): number {
  if (functionCode >= 0x80) {
    if (direction === 'request' || codeRange(functionCode & 0x7f) !== 'public') return -9;
    const reason = fields['exceptionCode'];
    return 2 + (typeof reason !== 'number' ? 0 : KNOWN_EXCEPTIONS.has(reason) ? 5 : -5);
  }
  if (COMMON.has(functionCode)) return 5;
  return codeRange(functionCode) === 'public' ? 3 : -5;
}

function unitBits(unitId: number | undefined, { transport, direction }: Reading): number {
  if (unitId === undefined) return 0;
  if (transport === 'tcp') return unitId === TCP_DIRECT || unitId <= 1 ? 2 : unitId <= LAST_UNIT ? 0 : -3;
  if (unitId === 0) return direction === 'response' ? -4 : -1;
  return unitId === 1 ? 3 : unitId <= 32 ? 1 : unitId <= LAST_UNIT ? 0 : -6;
}

/** The evidence of a frame whose fields end where the bytes end. */
export function endsThere({ spans, open, problems }: Reading): number {
  if (problems.some(({ code }) => ENDS_ELSEWHERE.has(code))) return -ENDS_BITS;
  return open ? 0 : ENDS_BITS + (spans.some(({ kind }) => kind === 'count') ? 4 : 0);
}
