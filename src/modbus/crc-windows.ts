import { crc16 } from './crc16.ts';

const INITIAL = 0xffff;
/** A register is moved on by the length of a window in two steps: by multiples of 16 zero bytes, and by the rest. */
const STEP = 16;
const TABLE = 512;
const ZERO = new Uint8Array(STEP);

/**
 * Tables that move a register on by 0, `zeros`, 2 `zeros` … zero bytes: for each of these, 256 entries for its low byte
 * and 256 for its high one. A CRC is linear over xor, so both are added.
 */
function moves(number: number, zeros: number): Uint16Array {
  const tables = new Uint16Array(number * TABLE);
  for (let byte = 0; byte < 256; byte++) {
    tables[byte] = byte;
    tables[256 + byte] = byte << 8;
  }
  for (let i = TABLE; i < tables.length; i++) tables[i] = crc16(ZERO, 0, zeros, tables[i - TABLE] as number);
  return tables;
}

const moved = (tables: Uint16Array, by: number, register: number): number =>
  (tables[by * TABLE + (register & 0xff)] as number) ^ (tables[by * TABLE + 256 + (register >>> 8)] as number);

/** Made when first needed: most who load this never look through a stream. */
let tables: { readonly ones: Uint16Array; readonly steps: Uint16Array } | undefined;

/** The CRC-16/MODBUS of overlapping windows of a stream, each in the same short time, of at most 256 bytes (SL 2.5.1.2). */
export class CrcWindows {
  /** The register after each byte; before the first it is 0. */
  readonly registers: Uint16Array;
  readonly #ones: Uint16Array;
  readonly #steps: Uint16Array;

  constructor(bytes: Uint8Array) {
    tables ??= { ones: moves(STEP, 1), steps: moves(STEP + 1, STEP) };
    this.#ones = tables.ones;
    this.#steps = tables.steps;
    const step = tables.ones.subarray(TABLE, TABLE + 256);
    const registers = new Uint16Array(bytes.length + 1);
    let register = 0;
    for (let i = 0; i < bytes.length; i++) {
      register = (register >>> 8) ^ (step[(register ^ (bytes[i] as number)) & 0xff] as number);
      registers[i + 1] = register;
    }
    this.registers = registers;
  }

  /** Whether `bytes[from, to)` end in their CRC, so that no residue is left. */
  closes(from: number, to: number): boolean {
    const length = to - from;
    const before = (this.registers[from] as number) ^ INITIAL;
    const left = moved(this.#ones, length & 15, before);
    return (length < STEP ? left : moved(this.#steps, length >>> 4, left)) === this.registers[to];
  }

  /** The table that moves a register on by `length` bytes, fewer than 16: 256 entries for its low byte, 256 for its high. */
  mover(length: number): Uint16Array {
    return this.#ones.subarray(length * TABLE, (length + 1) * TABLE);
  }
}
