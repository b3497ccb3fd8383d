import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import type { Register } from '../../../../src/devices/index.ts';
import { readRegisterMap } from '../../../../src/devices/maps/index.ts';

/** Maps as makers and programs write them, with the registers that they mean; types as they are named, with what is meant. */
interface Kinds {
  readonly maps: readonly {
    readonly id: string;
    readonly encoding?: 'utf-16le' | 'utf-16be' | 'windows-1252';
    readonly name?: string;
    readonly text: string;
    readonly answers?: Readonly<Record<string, string>>;
    /** As `inShort` writes them. */
    readonly registers: readonly string[];
    readonly asks: readonly string[];
    /** Codes of faults and of notices besides `assumed`. */
    readonly tells?: readonly string[];
  }[];
  readonly types: readonly (readonly [string, string])[];
}
const { maps, types }: Kinds = JSON.parse(
  readFileSync(new URL('../../../vectors/map-kinds.json', import.meta.url), 'utf8'),
);

const TABLES = { 'holding-register': 'h', 'input-register': 'i', coil: 'c', 'discrete-input': 'd' };

/** `Flow|h0 i16 CDAB x2 *0.1 +-40 °C {0=Off} r <A,B> @Group`: what is usual is left away, and what a read-only table says anyway. */
function inShort(register: Register, withGroup: boolean): string {
  const { name, table, address, type, order, count, factor, offset, unit, names, access, mask, models, group } =
    register;
  return [
    `${name}|${TABLES[table]}${address} ${type}`,
    order === 'ABCD' ? '' : order,
    count === 1 ? '' : `x${count}`,
    Number(factor) === 1 ? '' : `*${Number(Number(factor).toPrecision(9))}`,
    offset ? `+${offset}` : '',
    register.scaleRegister ? `sf${register.scaleRegister.address}` : '',
    mask === undefined ? '' : `&${mask.toString(16)}`,
    unit,
    names.length === 0 ? '' : `{${names.map((one) => `${one.number}=${one.name}`).join(';')}}`,
    /^[hc]/.test(TABLES[table]) && access !== 'rw' ? access : '',
    models ? `<${models.join()}>` : '',
    withGroup && group ? `@${group}` : '',
    register.notImplemented === undefined ? '' : `ni${register.notImplemented}`,
  ]
    .filter((part) => part !== '')
    .join(' ');
}

function bytesOf(text: string, encoding: string): Uint8Array {
  if (encoding === 'windows-1252') return Uint8Array.from(text, (letter) => letter.charCodeAt(0));
  const view = new DataView(new ArrayBuffer(text.length * 2));
  for (let at = 0; at < text.length; at++) view.setUint16(at * 2, text.charCodeAt(at), encoding === 'utf-16le');
  return new Uint8Array(view.buffer);
}

describe('register maps', () => {
  it.each(maps)('$id', ({ text, encoding, name = '', answers = {}, registers, asks, tells = [] }) => {
    const read = readRegisterMap(encoding === undefined ? text : bytesOf(text, encoding), { name, answers });
    const withGroup = registers.some((one) => one.includes(' @'));
    expect(read.profile.registers.map((one) => inShort(one, withGroup))).toEqual(registers);
    expect(read.questions.map(({ code }) => code)).toEqual(asks);
    const told = [...read.notices, ...read.faults].map(({ code }) => code).filter((code) => code !== 'assumed');
    expect([...new Set(told)]).toEqual(tells);
  });

  it('asks three times at most', () => {
    expect(maps.filter(({ asks }) => asks.length > 3)).toEqual([]);
  });
});

describe('names of types', () => {
  it.each(types)('%s', (name, type) => {
    const text = `Name\tTable\tAddress\tType\nP\tholding\t10\t${name}\nQ\tholding\t100\tuint16\nR\tholding\t101\tint16\n`;
    const [first] = readRegisterMap(text).profile.registers;
    expect(first && inShort(first, false)).toBe(`P|h10 ${type}`);
  });
});
