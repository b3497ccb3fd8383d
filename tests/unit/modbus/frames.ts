import { expect } from 'vitest';
import {
  type DecodeContext,
  type Direction,
  decodeFrame,
  encodeFrame,
  fromHex,
  type Reading,
  toHex,
} from '../../../src/modbus/index.ts';

/** The bytes that hexadecimal pairs say; blanks between them are free. */
export function hex(text: string): Uint8Array {
  const bytes = fromHex(text);
  if (bytes === undefined) throw new Error(`not hexadecimal pairs: ${text}`);
  return bytes;
}

/** The characters of an ASCII frame as bytes. */
export const characters = (text: string): Uint8Array => Uint8Array.from(text, (one) => one.charCodeAt(0));

/** A 16-bit number as its two bytes, high byte first. */
export const word = (value: number): number[] => [value >> 8, value & 0xff];

export const zeros = (number: number): number[] => new Array<number>(number).fill(0);

export const readPdu = (direction: Direction, bytes: readonly number[], request?: readonly number[]): Reading =>
  decodeFrame(Uint8Array.from(bytes), { transport: 'pdu', direction, request: request && Uint8Array.from(request) });

/** What is said of a frame, in the order of its finding: `error quantity-out-of-range`. */
export const said = ({ problems }: Reading): string[] => problems.map(({ severity, code }) => `${severity} ${code}`);

/** The same with the places: `error quantity-out-of-range 4-6`. */
export const saidWhere = ({ problems }: Reading): string[] =>
  problems.map(({ severity, code, span }) => `${severity} ${code} ${span.from}-${span.to}`);

/** Errors and warnings; notes leave a frame clean. */
export const isFlagged = ({ problems }: Reading): boolean => problems.some(({ severity }) => severity !== 'note');

/** The frame that encoding makes of everything a reading says. */
export const encodedAgain = (reading: Reading): string => toHex(encodeFrame({ ...reading, force: reading.forced }));

/** Every byte lies in exactly one span, in order, and no span is empty. */
export function expectEveryByteInOneSpan({ spans }: Reading, length: number): void {
  let at = 0;
  for (const { name, from, to } of spans) {
    if (from !== at || to <= from) expect.unreachable(`${name} is [${from}, ${to}) where ${at} comes next`);
    at = to;
  }
  if (at !== length) expect(at).toBe(length);
}

/** One PDU of the specification and what its bytes say. */
export interface LiteralPdu {
  readonly what: string;
  readonly direction: Direction;
  readonly bytes: readonly number[];
  readonly fields: Readonly<Record<string, unknown>>;
  /** What the encoder works out. */
  readonly derived?: Readonly<Record<string, unknown>>;
  readonly request?: readonly number[];
  readonly notes?: readonly string[];
}

/** Decodes the bytes to the fields without a fault, and encodes the fields to the bytes. */
export function expectBothWays({ direction, bytes, fields, derived = {}, request, notes = [] }: LiteralPdu): void {
  const reading = readPdu(direction, bytes, request);
  expect(reading).toMatchObject({ functionCode: bytes[0], outcome: { kind: 'whole' }, forced: {} });
  expect(reading.fields).toEqual(fields);
  expect(reading.derived).toEqual(derived);
  expect(said(reading)).toEqual(notes);
  expectEveryByteInOneSpan(reading, bytes.length);
  const functionCode = bytes[0];
  expect(Array.from(encodeFrame({ transport: 'pdu', direction, functionCode, fields }))).toEqual(bytes);
}

/** What is said of a frame, by its hexadecimal pairs. */
export const saidOf = (text: string, context: DecodeContext): string[] => said(decodeFrame(hex(text), context));
