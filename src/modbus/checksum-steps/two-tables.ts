import { demandWhole } from '../demand.ts';
import type { CrcSteps } from './crc-steps.ts';

/**
 * The table of a 16-bit CRC as two of bytes, for processors that have no 16-bit registers: `first` has the byte of each
 * entry that is sent first, which is the one the data meets. In SL 6.2.2 they are auchCRCHi and auchCRCLo.
 */
export interface TwoTables {
  readonly first: Uint8Array;
  readonly second: Uint8Array;
}

/** What one byte does to the two halves of the register. */
export interface TwoTableStep {
  readonly before: { readonly first: number; readonly second: number };
  /** The byte xor the first half. */
  readonly index: number;
  /** The first half is the old second one xor its entry; the second half is its entry. */
  readonly after: { readonly first: number; readonly second: number };
}

/** The two tables of a CRC; `undefined` if it does not have 16 bits. */
export function twoTables({ algorithm, form, table }: CrcSteps): TwoTables | undefined {
  if (algorithm.width !== 16) return undefined;
  const low = Uint8Array.from(table);
  const high = Uint8Array.from(table, (entry) => entry >>> 8);
  return form.reflected ? { first: low, second: high } : { first: high, second: low };
}

/** What the byte at a place does by the two tables. Throws a `RangeError` for a place without a byte. */
export function twoTableStep({ first, second }: TwoTables, steps: CrcSteps, at: number): TwoTableStep {
  demandWhole('place', at, 0, steps.bytes.length - 1);
  const register = steps.registers[at] as number;
  const [low, high] = [register & 0xff, register >>> 8];
  const before = steps.form.reflected ? { first: low, second: high } : { first: high, second: low };
  const index = before.first ^ (steps.bytes[at] as number);
  const after = { first: before.second ^ (first[index] as number), second: second[index] as number };
  return { before, index, after };
}
