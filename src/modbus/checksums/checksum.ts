import { crcAdd, crcStart, crcValue, xor8 } from '../crc.ts';
import { type CatalogueCrc, crcCatalogue } from '../crc-catalogue.ts';
import { crc16 } from '../crc16.ts';
import { demandPart } from '../demand.ts';
import { dictionary } from '../dictionary.ts';
import { byteSum } from './byte-sum.ts';
import { joinRegisters } from './join.ts';

/**
 * A checksum by its name, for bytes that come in pieces: each `add` continues from the state of the previous one, the first
 * from `start`, and `value` gives the checksum of the last. The order in which the bytes of a value are sent is not part of
 * it.
 */
export interface Checksum {
  readonly name: string;
  readonly aliases: readonly string[];
  /** Bits. */
  readonly width: number;
  /** The checksum of the nine characters `123456789`. */
  readonly check: number;
  /** Its parameters, if it is a CRC. */
  readonly crc?: CatalogueCrc;
  readonly start: number;
  /** The state after `bytes[from, to)`. */
  add(state: number, bytes: Uint8Array, from?: number, to?: number): number;
  value(state: number): number;
  /**
   * The state after two runs of bytes that were processed in parallel: the first from `start`, the other, of `size` bytes,
   * from zero. Absent if a run cannot be processed without the previous one.
   */
  join?(first: number, second: number, size: number): number;
}

/** The checksum of `bytes[from, to)`. */
export const checksum = (of: Checksum, bytes: Uint8Array, from = 0, to = bytes.length): number =>
  of.value(of.add(of.start, bytes, from, to));

/** Names that calculators on the web use, besides those of the catalogue. */
const calculatorNames: Readonly<Record<string, readonly string[]>> = dictionary({
  'CRC-16/MODBUS': ['CRC-16 (Modbus)'],
  'CRC-16/XMODEM': ['CRC-CCITT (XModem)'],
  'CRC-16/IBM-3740': ['CRC-CCITT (0xFFFF)'],
  'CRC-16/SPI-FUJITSU': ['CRC-CCITT (0x1D0F)'],
  'CRC-16/KERMIT': ['CRC-CCITT (Kermit)'],
  'CRC-16/DNP': ['CRC-DNP'],
});

/** A CRC as a checksum. Throws a `RangeError` for a width other than 1 to 32. */
export function crcChecksum(row: CatalogueCrc): Checksum {
  const { name, width, check } = row;
  const modbus = name === 'CRC-16/MODBUS';
  return {
    name,
    aliases: [...row.aliases, ...(calculatorNames[name] ?? [])],
    width,
    check,
    crc: row,
    start: crcStart(row),
    add: modbus
      ? (state, bytes, from, to) => crc16(bytes, from, to, state)
      : (state, bytes, from, to) => crcAdd(row, state, bytes, from, to),
    value: (state) => crcValue(row, state),
    join: (first, second, size) => joinRegisters(row, first, second, size),
  };
}

const asItIs = (state: number) => state;

/** Checksums that are not CRCs: those of Modbus, and those of the calculators with which people check it. */
const sums: readonly Checksum[] = [
  {
    name: 'LRC',
    aliases: ['Modbus ASCII', 'LRC-8'],
    width: 8,
    check: 0x23,
    start: 0,
    add: (state, bytes, from = 0, to = bytes.length) => (state + byteSum(bytes, from, to)) & 0xff,
    value: (state) => -state & 0xff,
    join: (first, second) => (first + second) & 0xff,
  },
  {
    name: 'SUM-8',
    aliases: ['1 byte checksum'],
    width: 8,
    check: 0xdd,
    start: 0,
    add: (state, bytes, from = 0, to = bytes.length) => (state + byteSum(bytes, from, to)) & 0xff,
    value: asItIs,
    join: (first, second) => (first + second) & 0xff,
  },
  {
    name: 'XOR-8',
    aliases: ['BCC'],
    width: 8,
    check: 0x31,
    start: 0,
    add: (state, bytes, from, to) => state ^ xor8(bytes, from, to),
    value: asItIs,
    join: (first, second) => first ^ second,
  },
  {
    name: 'Sick',
    aliases: ['CRC-16 (Sick)'],
    width: 16,
    check: 0xa656,
    start: 0,
    add: addSick,
    value: (state) => state & 0xffff,
  },
];

/** Like the polynomial 8005, but each byte goes in together with the previous one, which the state holds above the register. */
function addSick(state: number, bytes: Uint8Array, from = 0, to = bytes.length): number {
  demandPart(bytes, from, to);
  let register = state & 0xffff;
  let before = state >>> 16;
  for (let i = from; i < to; i++) {
    const byte = bytes[i] as number;
    register = ((register << 1) ^ (register & 0x8000 ? 0x18005 : 0) ^ (before << 8) ^ byte) & 0xffff;
    before = byte;
  }
  return (before << 16) | register;
}

/** All checksums that have a name: the catalogue, and those that are not CRCs. */
export const checksums: readonly Checksum[] = [...crcCatalogue.map(crcChecksum), ...sums];
