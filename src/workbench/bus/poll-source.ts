import { type Place, type PlannedRead, planReads, requestFor } from '../../bus/index.ts';
import {
  canRead,
  countsValues,
  inUnits,
  isBitTable,
  mostRead,
  type Profile,
  plainRegister,
  printedNumber,
  type Register,
  rawOf,
  saysNothing,
  stepOf,
  valueName,
  valuesOf,
} from '../../devices/index.ts';
import {
  BROADCAST,
  type FunctionCode,
  fieldValue,
  isNumberType,
  numberTypes,
  quantityOf,
  type Reading,
  type SerialMode,
  type Value,
} from '../../modbus/index.ts';
import { entityNumber } from '../../notation/index.ts';
import { isSixDigits } from '../frame/address-typed.ts';
import type { Draft } from '../frame/draft.ts';
import type { Evaluation } from '../frame/evaluate.ts';
import { linesFor, type PollSettings } from './poll-settings.ts';
import { wantedValues } from './wanted-values.ts';

/** One of the values that are polled. */
export interface PolledValue {
  readonly name: string;
  /** Its address as the manual prints it, and in hexadecimal. */
  readonly place: string;
  readonly register: Register;
  readonly where: Place;
  /** Where its power of ten is, of a line that has a scale register. */
  readonly power?: Place | undefined;
}

/** All that is polled: requests, and the values that are in their replies. */
export interface PollSource {
  readonly title: string;
  readonly transport: SerialMode;
  readonly requests: readonly Uint8Array[];
  readonly reads: readonly Pick<PlannedRead, 'quantity' | 'width'>[];
  readonly values: readonly PolledValue[];
  /** Values that no request can read whole. */
  readonly unreadable: readonly string[];
}

/** Why there is nothing to poll. */
export type SourceRefusal =
  | 'no-frame'
  | 'not-request'
  | 'not-serial'
  | 'reads-nothing'
  | 'broadcast'
  | 'nothing-chosen'
  | 'too-many';

/** The texts of a source. */
export interface SourceWords {
  /** The name of an element that has none. */
  readonly name: (register: Register) => string;
  /** An address as printed, and counted from 0. */
  readonly place: (printed: string, address: number) => string;
  readonly frameTitle: (reading: Reading, size: number, transport: SerialMode) => string;
  readonly deviceTitle: (name: string, unit: number) => string;
}

const MOST_VALUES = 2000;

/** A request as something to poll: each register or bit that it reads is a value. */
export function frameSource(draft: Draft, { frame }: Evaluation, words: SourceWords): PollSource | SourceRefusal {
  if (frame === undefined) return 'no-frame';
  const { transport, kind } = draft;
  if (kind !== 'request') return 'not-request';
  if (transport !== 'rtu' && transport !== 'ascii') return 'not-serial';
  const { reading, bytes } = frame;
  const { description, unitId } = reading;
  const table = description?.table;
  const addressName = ['startAddress', 'readStartAddress'].find((name) => Object.hasOwn(reading.fields, name));
  const address = addressName && fieldValue(reading, addressName);
  const quantity = addressName && fieldValue(reading, quantityOf(addressName) ?? '');
  if (table === undefined || table === 'file-record' || !answersWithList(description)) return 'reads-nothing';
  if (typeof address !== 'number' || typeof quantity !== 'number') return 'reads-nothing';
  if (unitId === BROADCAST) return 'broadcast';
  const inSixDigits = isSixDigits(draft);
  const count = Math.min(quantity, isBitTable(table) ? mostRead.bits : mostRead.registers);
  return {
    title: words.frameTitle(reading, bytes.length, transport),
    transport,
    requests: [bytes],
    reads: [{ quantity: count, width: 1 }],
    values: Array.from({ length: count }, (_, at) => {
      const register: Register = { ...plainRegister, name: '', table, address: address + at };
      return {
        name: words.name(register),
        place: words.place(entityNumber(table, address + at, inSixDigits), address + at),
        register,
        where: { read: 0, at, size: 1 },
      };
    }),
    unreadable: [],
  };
}

const answersWithList = (description: FunctionCode | undefined) =>
  description?.response.fields.some(({ kind }) => kind === 'registers' || kind === 'bits') ?? false;

/** What a line, or one value of it, is called among those chosen. */
export const lineKey = (register: Register, index: number | undefined): string =>
  index === undefined ? register.name : `${register.name}#${index}`;

/** Chosen lines of a device as something to poll. */
export function deviceSource(
  profile: Profile,
  settings: PollSettings,
  transport: SerialMode,
  words: SourceWords,
): PollSource | SourceRefusal {
  const { unit, registers, bits, gap } = settings;
  const chosen = new Set(linesFor(settings, profile.id));
  const found = profile.registers.filter(canRead).flatMap((register) => {
    const whole = chosen.has(lineKey(register, undefined));
    const all = Array.from({ length: valuesOf(register) }, (_, index) => index);
    return all.filter((index) => whole || chosen.has(lineKey(register, index))).map((index) => ({ register, index }));
  });
  if (found.length === 0) return 'nothing-chosen';
  if (found.length > MOST_VALUES) return 'too-many';
  // What is between values that a device counts in its own way has a size that nobody knows.
  const known = !countsValues(profile);
  const { wanted, powers } = wantedValues(profile, found, unit);
  const plan = planReads(wanted, { registers, bits, gap: known ? gap : 0 });
  const name = ({ register, index }: (typeof found)[number]) => valueName(register, index);
  return {
    title: words.deviceTitle(profile.name, unit),
    transport,
    requests: plan.reads.map((read) => requestFor(read, transport)),
    reads: plan.reads,
    values: found.flatMap((each, index) => {
      const where = plan.places[index];
      const { register } = each;
      const address = register.address + each.index * stepOf(register, profile);
      const printed = printedNumber(profile.convention, register.table, address);
      const power = plan.places[powers[index] ?? -1];
      return where ? [{ name: name(each), place: words.place(printed, address), register, where, power }] : [];
    }),
    unreadable: found.filter((_, index) => plan.places[index] === undefined).map(name),
  };
}

/** What a value's registers or bits hold; `undefined` if they hold nothing of its type. */
export const heldBy = ({ register }: PolledValue, items: readonly number[]): Value | undefined =>
  isBitTable(register.table) ? items[0] : rawOf(items, register);

/**
 * What a value counts as, in its unit, with the power of ten of its scale register. `undefined` for texts, where the device says
 * that it has no such value, and where the power is not known.
 */
export function numberOf(raw: Value, { register }: PolledValue, power?: number): number | bigint | undefined {
  if (typeof raw === 'string' || saysNothing(raw, register)) return undefined;
  if (isBitTable(register.table)) return raw;
  return register.scaleRegister && power === undefined ? undefined : inUnits(raw, register, power);
}

/** Whether a value can be drawn, and has a least and a most. */
export const isNumber = ({ register: { table, type } }: PolledValue): boolean =>
  isBitTable(table) || (isNumberType(type) && numberTypes[type].kind !== 'bits');
