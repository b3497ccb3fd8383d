import { byteOrders, valueTypes } from './codec.ts';
import { readRatio } from './line-scale.ts';
import { accesses, conventions, entityTables, type NamedNumber, type Profile, type Register } from './profile.ts';
import { readSerial } from './table.ts';
import { traits } from './traits.ts';

type Check = (value: unknown) => boolean;
type Loose = Readonly<Record<string, unknown>>;

const text: Check = (value) => typeof value === 'string';
const whole =
  (least: number, most: number): Check =>
  (value) =>
    Number.isInteger(value) && least <= (value as number) && (value as number) <= most;
const oneOf = (known: readonly unknown[]): Check => {
  const all = new Set(known);
  return (value) => all.has(value);
};
const list =
  (item: Check): Check =>
  (value) =>
    Array.isArray(value) && value.every(item);
const absentOr =
  (check: Check): Check =>
  (value) =>
    value === undefined || check(value);
const object = (checks: Readonly<Record<string, Check>>): Check => {
  const all = Object.entries(checks).map(([key, check]) => ({ key, check }));
  return (value) => isObject(value) && all.every(({ key, check }) => check(value[key]));
};
const ratio: Check = (value) => typeof value === 'string' && readRatio(value) !== undefined;

const isObject = (value: unknown): value is Loose =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

const LAST_ADDRESS = 0xffff;
const address = whole(0, LAST_ADDRESS);

const register = object({
  name: text,
  table: oneOf(entityTables),
  address,
  type: oneOf(valueTypes),
  order: oneOf(byteOrders),
  count: whole(1, LAST_ADDRESS + 1),
  factor: (value) => Number.isFinite(value) && value !== 0,
  offset: Number.isFinite,
  exact: absentOr(object({ factor: ratio, offset: ratio })),
  scaleRegister: absentOr(object({ address })),
  notImplemented: absentOr(text),
  mask: absentOr(whole(1, Number.MAX_SAFE_INTEGER)),
  unit: text,
  decimals: absentOr(whole(0, 10)),
  access: oneOf(accesses),
  names: list(object({ number: Number.isInteger, name: text } satisfies Record<keyof NamedNumber, Check>)),
  description: text,
  group: absentOr(text),
  models: absentOr(list(text)),
} satisfies Record<keyof Register, Check>);

const profile = object({
  id: (value) => text(value) && value !== '',
  name: (value) => text(value) && value !== '',
  source: text,
  convention: oneOf(conventions),
  serial: absentOr(isSerial),
  unit: absentOr(whole(0, 255)),
  traits: list(oneOf(traits)),
  registers: list(register),
  notes: list(text),
  answers: absentOr((value) => isObject(value) && Object.values(value).every(text)),
} satisfies Record<keyof Profile, Check>);

function isSerial(value: unknown): boolean {
  if (!isObject(value)) return false;
  const { baud, dataBits, parity, stopBits, unit } = value;
  const read = readSerial([baud, dataBits, parity, stopBits, unit ?? ''].map(String));
  return read !== undefined && Object.entries(read).every(([key, setting]) => value[key] === setting);
}

/** Whether a value is a profile as it stands: quick, where `readProfiles` reads every cell and says what is wrong. */
export const isProfile = (value: unknown): value is Profile => profile(value);
