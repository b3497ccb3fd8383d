import { fieldValue, type Reading } from '../modbus/index.ts';
import { wordsOf } from './codec.ts';
import { addressesOf, stepOf } from './numbering.ts';
import { type EntityTable, isBitTable, isReadOnly, type Profile, type Register, type Trait } from './profile.ts';

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

/** The function that reads a table. */
export const readFunctions: Readonly<Record<EntityTable, number>> = {
  coil: 0x01,
  'discrete-input': 0x02,
  'holding-register': 0x03,
  'input-register': 0x04,
};

/** Most elements that one request reads (AP 6.1, 6.3). */
export const mostRead = { bits: 2000, registers: 125 } as const;
/** Most elements that one request writes (AP 6.11, 6.12). */
const MOST_WRITTEN = { bits: 1968, registers: 123 };

export const canRead = ({ access }: Register): boolean => access !== 'w';
export const canWrite = ({ access, table }: Register): boolean => access !== 'r' && !isReadOnly(table);

/** What reads a line, or one value of it by its index. No value is cut in two where it fits into a request. */
export function readRequests(profile: Profile, register: Register, index?: number): readonly ReadRequest[] {
  const { address, quantity } = placeOf(profile, register, index);
  const step = stepOf(register, profile);
  const values = isBitTable(register.table) ? mostRead.bits : Math.floor(mostRead.registers / wordsOf(register.type));
  const each = values * step;
  return Array.from({ length: Math.ceil(quantity / each) }, (_, part) => ({
    functionCode: readFunctions[register.table],
    fields: { startAddress: address + part * each, quantity: Math.min(each, quantity - part * each) },
    force: {},
  }));
}

/** What reads a line, or one value of it; of a line longer than a request may be, its beginning. */
export function readRequest(profile: Profile, register: Register, index?: number): ReadRequest {
  return readRequests(profile, register, index)[0] as ReadRequest;
}

/** What writes zeros into a line, or into one value of it: 05 and 06 where it is one element, else 0F and 10. */
export function writeRequest(profile: Profile, register: Register, index?: number): RegisterRequest {
  const { address, quantity } = placeOf(profile, register, index);
  const bits = isBitTable(register.table);
  const each = bits ? 1 : wordsOf(register.type) / stepOf(register, profile);
  if (quantity * each === 1) return { functionCode: bits ? 0x05 : 0x06, fields: { address, value: 0 }, force: {} };
  const many = Math.min(quantity, Math.floor((bits ? MOST_WRITTEN.bits : MOST_WRITTEN.registers) / each));
  const zeros = new Array<number>(many * each).fill(0);
  return {
    functionCode: bits ? 0x0f : 0x10,
    fields: { startAddress: address, [bits ? 'bits' : 'registers']: zeros },
    force: each === 1 ? {} : { quantity: many },
  };
}

function placeOf(profile: Profile, register: Register, index: number | undefined) {
  if (index === undefined || register.type === 'text')
    return { address: register.address, quantity: addressesOf(register, profile) };
  const step = stepOf(register, profile);
  return { address: register.address + index * step, quantity: step };
}

/** The byte count that a device wants of a request 0F, where it is not the specification's. */
export function ownByteCount({ traits }: Profile, reading: Reading): number | undefined {
  const quantity = fieldValue(reading, 'quantity');
  if (reading.functionCode !== 0x0f || reading.direction !== 'request' || typeof quantity !== 'number')
    return undefined;
  const own = coilByteCount(quantity, traits);
  return own === coilByteCount(quantity, []) ? undefined : own;
}

/** The byte count of a request 0F for so many coils, as a device wants it (AP 6.11: n/8, rounded up). */
export const coilByteCount = (quantity: number, traits: readonly Trait[]): number =>
  traits.includes('byte-count-plus-one') ? 1 + Math.floor(quantity / 8) : Math.ceil(quantity / 8);
