import type { CrcAlgorithm } from '../crc-catalogue.ts';
import { demandWhole } from '../demand.ts';
import {
  leaving,
  movedByByte,
  outOf,
  placed,
  type RegisterForm,
  registerForm,
  shifted,
  withoutXor,
} from './register.ts';

/** Shifts a byte. */
const SHIFTS = 8;

/** What one byte does to the register, with and without the table. */
export interface ByteStep {
  readonly value: number;
  readonly before: number;
  /** The register with the byte xored in, before the first shift. */
  readonly mixed: number;
  /** The index into the table: the eight bits of `mixed` that leave next. */
  readonly index: number;
  readonly entry: number;
  /** `mixed` moved by eight bits: `after` is this xor `entry`. */
  readonly moved: number;
  readonly after: number;
}

/** One shift. The polynomial is xored in if `out` is 1. */
export interface ShiftStep {
  readonly before: number;
  /** The bit moved out. */
  readonly out: 0 | 1;
  readonly after: number;
}

/** The register after some shifts of a byte, and the two parts of which it is the xor. */
export interface SplitShift {
  readonly whole: number;
  /** The contribution of the eight bits that leave; after the eighth shift, the entry of the table. */
  readonly index: number;
  /** The contribution of the other bits: they only move. */
  readonly rest: number;
}

/**
 * How a CRC of up to 32 bits is computed, bit by bit (SL 6.2). The registers between bytes are kept; the shifts of a byte
 * are computed on demand. Throws a `RangeError` for a width other than 1 to 32.
 */
export class CrcSteps {
  readonly algorithm: CrcAlgorithm;
  readonly form: RegisterForm;
  readonly bytes: Uint8Array;
  /** The register after eight shifts of each byte, alone in the register. */
  readonly table: Uint32Array;
  /** The register before each byte, and after the last. */
  readonly registers: Uint32Array;

  constructor(algorithm: CrcAlgorithm, bytes: Uint8Array) {
    this.algorithm = algorithm;
    this.bytes = bytes;
    this.form = registerForm(algorithm);
    const { form } = this;
    this.table = tableOf(algorithm, form);
    this.registers = new Uint32Array(bytes.length + 1);
    let register = form.initial;
    this.registers[0] = register;
    for (let at = 0; at < bytes.length; at++) {
      register = this.step(register, bytes[at] as number).after;
      this.registers[at + 1] = register;
    }
  }

  /** What the byte at a place does. Throws a `RangeError` for a place without a byte; so do `shifts` and `split`. */
  byte(at: number): ByteStep {
    demandWhole('place', at, 0, this.bytes.length - 1);
    return this.step(this.registers[at] as number, this.bytes[at] as number);
  }

  /** The eight shifts of the byte at a place. */
  shifts(at: number): readonly ShiftStep[] {
    const { form } = this;
    let before = this.byte(at).mixed;
    return Array.from({ length: SHIFTS }, () => {
      const step: ShiftStep = { before, out: outOf(form, before), after: shifted(form, before) };
      before = step.after;
      return step;
    });
  }

  /**
   * Why the table can replace the shifts of the byte at a place: the register after 0 to 8 of them, split into the
   * contributions of the bits that leave and of the others.
   */
  split(at: number): readonly SplitShift[] {
    const { form } = this;
    const { mixed, index } = this.byte(at);
    const alone = placed(form, index);
    let parts: SplitShift = { whole: mixed, index: alone, rest: (mixed ^ alone) >>> 0 };
    const all = [parts];
    for (let i = 0; i < SHIFTS; i++) {
      parts = {
        whole: shifted(form, parts.whole),
        index: shifted(form, parts.index),
        rest: shifted(form, parts.rest),
      };
      all.push(parts);
    }
    return all;
  }

  /** The register after the last byte. */
  get last(): number {
    return this.registers[this.bytes.length] as number;
  }

  /** The register after the last byte as the CRC has it: reflected if input and output differ, but not yet xored. */
  get unxored(): number {
    return withoutXor(this.algorithm, this.last);
  }

  /** The CRC, as `crc` gives it. */
  get value(): number {
    return (this.unxored ^ this.algorithm.xorout) >>> 0;
  }

  private step(before: number, value: number): ByteStep {
    const { form } = this;
    const mixed = (before ^ placed(form, value)) >>> 0;
    const index = leaving(form, mixed);
    const entry = this.table[index] as number;
    const moved = movedByByte(form, mixed);
    return { value, before, mixed, index, entry, moved, after: (moved ^ entry) >>> 0 };
  }
}

/** Made once an algorithm. */
const tables = new WeakMap<CrcAlgorithm, Uint32Array>();

function tableOf(algorithm: CrcAlgorithm, form: RegisterForm): Uint32Array {
  const known = tables.get(algorithm);
  if (known) return known;
  const table = Uint32Array.from({ length: 256 }, (_, byte) => afterByte(form, placed(form, byte)));
  tables.set(algorithm, table);
  return table;
}

function afterByte(form: RegisterForm, register: number): number {
  let after = register;
  for (let i = 0; i < SHIFTS; i++) after = shifted(form, after);
  return after;
}
