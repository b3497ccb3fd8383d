import type { Order } from '../../modbus/index.ts';
import { deviceUnit, type EntityTable, type NamedNumber, type Profile, type Register } from '../profile.ts';

const AREAS: Readonly<Record<EntityTable, string>> = {
  coil: 'coil',
  'discrete-input': 'discrete',
  'input-register': 'input',
  'holding-register': 'holding',
};

const ACCESS = { r: 'RO', w: 'WO', rw: 'RW' } as const;

/**
 * A profile as the text of a file `.mbmap.json`: addresses from 0, the order of words of most registers for the whole, and of each that
 * differs; value = raw × scale + offset. `readRegisterMap` reads it back.
 */
export function writeMbmap({ name, source, serial, unit, registers }: Profile): string {
  const orders = registers.map(({ order }) => order);
  const little = orders.filter((order) => order === 'CDAB').length * 2 > orders.length;
  const usual: Order = little ? 'CDAB' : 'ABCD';
  const own = deviceUnit({ serial, unit });
  const map = {
    format: 'mbmap',
    version: 1,
    name,
    ...(source === '' ? {} : { source }),
    ...(own === undefined ? {} : { unitId: own }),
    addressBase: 0,
    wordOrder: little ? 'little' : 'big',
    registers: registers.map((register) => entryOf(register, usual)),
  };
  return `${JSON.stringify(map, null, 2)}\n`;
}

function entryOf(register: Register, usual: Order): Readonly<Record<string, unknown>> {
  const { name, table, address, type, order, count, factor, offset, exact, unit, decimals, access, names } = register;
  const { mask, scaleRegister, notImplemented, group, models, description } = register;
  return {
    name,
    area: AREAS[table],
    address,
    type: typeText(type),
    ...(type === 'text' ? { length: count } : count === 1 ? {} : { count }),
    ...(order === usual ? {} : { wordOrder: order }),
    ...(exact ? { scale: exact.factor } : factor === 1 ? {} : { scale: factor }),
    ...(exact ? { offset: exact.offset } : offset === 0 ? {} : { offset }),
    ...(scaleRegister ? { scaleRegister: scaleRegister.address } : {}),
    ...(unit === '' ? {} : { unit }),
    ...(decimals === undefined ? {} : { decimals }),
    access: ACCESS[access],
    ...(names.length === 0 ? {} : { values: valuesOf(names) }),
    ...(mask === undefined ? {} : { mask }),
    ...(notImplemented === undefined ? {} : { notImplemented }),
    ...(group === undefined ? {} : { group }),
    ...(models === undefined ? {} : { models }),
    ...(description === '' ? {} : { description }),
  };
}

const valuesOf = (names: readonly NamedNumber[]) => names.map(({ number, name }) => ({ value: number, name }));

/** `uint16`, `int32`, `float64`, `string`; other types by our name. */
const typeText = (type: string): string =>
  type === 'text'
    ? 'string'
    : type.replace(/^([uif])(\d+)$/, (_whole, kind: 'u' | 'i' | 'f', bits: string) => `${KINDS[kind]}${bits}`);

const KINDS = { u: 'uint', i: 'int', f: 'float' } as const;
