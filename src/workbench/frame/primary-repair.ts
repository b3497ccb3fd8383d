import type { Finding, FindingCode } from '../../diagnosis/index.ts';
import { findingKinds } from '../../diagnosis/index.ts';
import { decodeFrame, sameBytes } from '../../modbus/index.ts';
import type { Evaluation } from './evaluate.ts';

/** The frame that was most probably meant, and what of it changes. */
export interface Repair {
  readonly finding: FindingCode;
  /** The whole repaired frame. */
  readonly bytes: Uint8Array;
  /** `checksum`: nothing but the checksum changes, or it is added; then `part` is the checksum. `frame`: `part` is all of it. */
  readonly changes: 'checksum' | 'frame';
  readonly part: Uint8Array;
}

/**
 * The one repair that is offered first: that of the first finding that has one. `undefined` while nothing is wrong, nothing was
 * found, or nothing that was found can be repaired.
 */
export function primaryRepair(frame: Evaluation['frame'], findings: readonly Finding[]): Repair | undefined {
  const [first] = findings;
  if (frame === undefined || first === undefined || findingKinds[first.code] === 'sound') return undefined;
  const finding = findings.find(({ repaired }) => repaired.some((bytes) => !sameBytes(bytes, frame.bytes)));
  const bytes = finding?.repaired.find((one) => !sameBytes(one, frame.bytes));
  if (finding === undefined || bytes === undefined) return undefined;
  const { transport, direction } = frame.reading;
  const checksum = decodeFrame(bytes, { transport, direction }).spans.find(({ kind }) => kind === 'checksum');
  const body = checksum && bytes.subarray(0, checksum.from);
  const behind = checksum && bytes.subarray(checksum.to);
  const mine = frame.bytes;
  const had = frame.reading.spans.find(({ kind }) => kind === 'checksum');
  const onlyChecksum =
    body !== undefined &&
    sameBytes(body, mine.subarray(0, had?.from ?? mine.length)) &&
    sameBytes(behind ?? new Uint8Array(), mine.subarray(had?.to ?? mine.length));
  return onlyChecksum && checksum
    ? { finding: finding.code, bytes, changes: 'checksum', part: bytes.subarray(checksum.from, checksum.to) }
    : { finding: finding.code, bytes, changes: 'frame', part: bytes };
}
