import { demandWhole, fieldValue, isTextType, mostOf, type Reading, readerOf, writerOf } from '../modbus/index.ts';
import { wordsOf } from './codec.ts';
import { linesAt } from './named.ts';
import { addressesOf, stepOf } from './numbering.ts';
import { isBitTable, isReadOnly, type Profile, type Register } from './profile.ts';
import { coilByteCount, countsValues } from './traits.ts';

/** The fields of a request, by the names that the function gives them, and what of it is forced. */
export interface RegisterRequest {
  readonly functionCode: number;
  readonly fields: Readonly<Record<string, number | readonly number[]>>;
  readonly force: Readonly<Record<string, number>>;
}

/** A request that reads from an address on. */
export interface ReadRequest extends RegisterRequest {
  readonly fields: { readonly startAddress: number; readonly quantity: number };
}

/** Most elements that one request reads. */
export const mostRead = { bits: mostOf(readerOf('coil')), registers: mostOf(readerOf('holding-register')) };

export const canRead = ({ access }: Register): boolean => access !== 'w';
export const canWrite = ({ access, table }: Register): boolean => access !== 'r' && !isReadOnly(table);

/** The requests that read a line, or one value of it by its index. A value that fits into a request is not cut in two. */
export function readRequests(profile: Profile, register: Register, index?: number): readonly ReadRequest[] {
  const { address, quantity } = placeOf(profile, register, index);
  const step = stepOf(register, profile);
  demandWhole('quantity', quantity, 0, 0x10000);
  const reader = readerOf(register.table);
  const most = mostOf(reader);
  const each = step * (isBitTable(register.table) ? most : Math.floor(most / wordsOf(register.type)));
  return Array.from({ length: Math.ceil(quantity / each) }, (_, part) => ({
    functionCode: reader.code,
    fields: { startAddress: address + part * each, quantity: Math.min(each, quantity - part * each) },
    force: {},
  }));
}

/** The request that reads a line, or one value of it; for a line longer than a request may be, its beginning. */
export function readRequest(profile: Profile, register: Register, index?: number): ReadRequest {
  return readRequests(profile, register, index)[0] as ReadRequest;
}

/**
 * The request that reads a line, or one value of it, together with its scale register: where one request can read both, and the map
 * has all that stands between them. Else the request that reads the line alone.
 */
export function readWithScale(profile: Profile, register: Register, index?: number): ReadRequest {
  const alone = readRequest(profile, register, index);
  const { scaleRegister, table } = register;
  if (scaleRegister === undefined || countsValues(profile)) return alone;
  const { startAddress, quantity } = alone.fields;
  const first = Math.min(startAddress, scaleRegister.address);
  const count = Math.max(startAddress + quantity, scaleRegister.address + 1) - first;
  const isWhole =
    count <= mostOf(readerOf(table)) &&
    Array.from({ length: count }, (_, at) => first + at).every((address) =>
      linesAt(profile, table, address).some((line) => canRead(line.register)),
    );
  return isWhole ? { ...alone, fields: { startAddress: first, quantity: count } } : alone;
}

/**
 * The request that writes zeros into a line, or into one value of it: 05 or 06 for one element, 0F or 10 for more. Of a
 * line longer than a request may be, it writes the first values that fit whole.
 */
export function writeRequest(profile: Profile, register: Register, index?: number): RegisterRequest {
  const { address, quantity } = placeOf(profile, register, index);
  const step = stepOf(register, profile);
  const bits = isBitTable(register.table);
  const each = bits ? 1 : wordsOf(register.type);
  const table = bits ? 'coil' : 'holding-register';
  const values = quantity / step;
  if (values * each === 1)
    return { functionCode: writerOf(table, 'one').code, fields: { address, value: 0 }, force: {} };
  const writer = writerOf(table, 'many');
  const whole = Math.min(values, Math.floor(mostOf(writer) / each));
  const zeros = new Array<number>(whole * each).fill(0);
  return {
    functionCode: writer.code,
    fields: { startAddress: address, [bits ? 'bits' : 'registers']: zeros },
    force: each === step ? {} : { quantity: whole * step },
  };
}

function placeOf(profile: Profile, register: Register, index: number | undefined) {
  if (index === undefined || isTextType(register.type))
    return { address: register.address, quantity: addressesOf(register, profile) };
  const step = stepOf(register, profile);
  return { address: register.address + index * step, quantity: step };
}

/** The byte count that a device wants in a request 0F; `undefined` if it is the specification's. */
export function ownByteCount(profile: Profile, reading: Reading): number | undefined {
  const quantity = fieldValue(reading, 'quantity');
  if (
    reading.functionCode !== writerOf('coil', 'many').code ||
    reading.direction !== 'request' ||
    typeof quantity !== 'number'
  )
    return undefined;
  const own = coilByteCount(quantity, profile);
  return own === coilByteCount(quantity, { traits: [] }) ? undefined : own;
}
