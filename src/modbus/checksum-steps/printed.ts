import type { CrcAlgorithm } from '../crc-catalogue.ts';
import { CrcSteps, type ShiftStep } from './crc-steps.ts';
import { outOf, shifted } from './register.ts';

/** A shift as a document prints it. */
export interface PrintedShift {
  readonly out: 0 | 1;
  readonly after: number;
}

/** The way of a CRC as a document prints it: the shifts of its first byte, and the register after some bytes. */
export interface PrintedExample {
  readonly bytes: Uint8Array;
  /** The register with the first byte xored in. */
  readonly mixed: number;
  readonly shifts: readonly PrintedShift[];
  /** The register after the first byte, the second, …, as far as it is printed. */
  readonly registers: readonly number[];
  readonly value: number;
}

/** A printed shift beside the right one. */
export interface PrintedVerdict {
  readonly printed: PrintedShift;
  readonly right: ShiftStep;
  /** The shift by the rule, of the register that is printed before it. */
  readonly byRule: ShiftStep;
  /** `right`; `follows`: by the rule, but of a register that was wrong already; `wrong`: not by the rule either. */
  readonly kind: 'right' | 'follows' | 'wrong';
}

/** The worked example of a WEG drive guide for PLCs, which goes wrong in its first shift. */
export const wegExample: PrintedExample = {
  bytes: Uint8Array.of(0x06, 0x06, 0x02, 0xab, 0x10, 0x00),
  mixed: 0xfff9,
  shifts: [
    { out: 1, after: 0xd7fc },
    { out: 0, after: 0x6bfe },
    { out: 0, after: 0x35ff },
    { out: 1, after: 0xcaff },
    { out: 1, after: 0xb57f },
    { out: 1, after: 0xfabf },
    { out: 1, after: 0xdd5f },
    { out: 1, after: 0xbeaf },
  ],
  registers: [0xbeaf, 0x18be],
  value: 0xa1e6,
};

/** The printed shifts of the first byte, each beside the right one. */
export function checkPrinted(algorithm: CrcAlgorithm, { bytes, mixed, shifts }: PrintedExample): PrintedVerdict[] {
  const steps = new CrcSteps(algorithm, bytes);
  const { form } = steps;
  const rightly = steps.shifts(0);
  let before = mixed;
  return shifts.map((printed, i) => {
    const right = rightly[i] as ShiftStep;
    const byRule: ShiftStep = { before, out: outOf(form, before), after: shifted(form, before) };
    before = printed.after;
    return { printed, right, byRule, kind: kindOf(printed, right, byRule) };
  });
}

function kindOf({ out, after }: PrintedShift, right: ShiftStep, byRule: ShiftStep): PrintedVerdict['kind'] {
  if (out !== byRule.out || after !== byRule.after) return 'wrong';
  return byRule.before === right.before ? 'right' : 'follows';
}
