import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { namedValues } from '../../../../src/devices/index.ts';
import { readRegisterMap } from '../../../../src/devices/maps/index.ts';

interface Input {
  readonly id: string;
  readonly input: {
    readonly text?: string;
    readonly bytesLatin1?: string;
    readonly table?: 'input-register' | 'holding-register';
    readonly first?: number;
    readonly registers?: readonly number[];
  };
}

const inputs: readonly Input[] = JSON.parse(
  readFileSync(new URL('../../../vectors/field-maps.json', import.meta.url), 'utf8'),
);
const inputOf = (id: string) => inputs.find((one) => one.id === id)!.input;
const map = (id: string, answers = {}) => readRegisterMap(inputOf(id).text ?? '', { answers });
const codes = (told: readonly { readonly code: string }[]) => told.map(({ code }) => code);
const rowsOf = (told: readonly { readonly code: string; readonly rows: readonly number[] }[], code: string) =>
  told.find((one) => one.code === code)?.rows;
const places = (id: string) => map(id).profile.registers.map(({ table, address }) => `${table} ${address}`);
const values = (id: string) => {
  const { table = 'holding-register', first = 0, registers = [] } = inputOf(id);
  return namedValues(map(id).profile, table, first, registers).map(
    ({ scaled, register }) => `${scaled} ${register.unit}`,
  );
};

describe('tables from the field', () => {
  it('multiplies by a factor', () => {
    expect(values('factor-direction-0.1')).toEqual(['49 °C']);
  });

  it('takes a quantity for registers, and divides by a gain', () => {
    expect(values('quantity-is-registers')).toEqual(['5 kW', '7 kvar']);
  });

  it('asks whether 3 and 4 are functions or digits', () => {
    const read = map('function-code-as-table');
    expect(codes(read.questions)).toContain('function-or-digit');
    expect(read.notices).toContainEqual({ code: 'assumed', question: 'function-or-digit', rows: [2, 3] });
    expect(places('function-code-as-table')).toEqual(['input-register 0', 'holding-register 2']);
    const digits = map('function-code-as-table', { 'function-or-digit': 'digit' });
    expect(digits.profile.registers.map(({ table }) => table)).toEqual(['holding-register', 'input-register']);
    expect(codes(digits.questions)).not.toContain('function-or-digit');
  });

  it('reads a column with a letter among its digits in hexadecimal', () => {
    expect(places('hex-column-read-decimal')).toEqual([
      'holding-register 0',
      'holding-register 100',
      'holding-register 2999',
    ]);
  });

  it('reads grouped digits', () => {
    expect(places('address-german-thousands')).toEqual(['holding-register 1000', 'holding-register 1001']);
    expect(rowsOf(map('address-german-thousands').notices, 'number-grouped')).toEqual([2, 3]);
  });

  it('makes the bits of one register of rows of bits', () => {
    const { registers, convention } = map('bit-row-dot-zero').profile;
    expect(convention).toBe('five-digit');
    expect(registers).toMatchObject([
      {
        name: '40001',
        table: 'holding-register',
        address: 0,
        type: 'bits',
        names: [
          { number: 0, name: 'Pump runs' },
          { number: 1, name: 'Fault' },
        ],
      },
    ]);
  });

  it('reads five and six digits in one table', () => {
    expect(places('mixed-five-and-six-digits')).toEqual(['holding-register 0', 'holding-register 1']);
    expect(rowsOf(map('mixed-five-and-six-digits').notices, 'odd-number')).toEqual([3]);
  });

  it('does not read a number of another shape than the file says', () => {
    const read = map('explicit-convention-not-held');
    expect(read.profile.registers.map(({ name, address }) => `${name} ${address}`)).toEqual(['A 0', 'C 16']);
    expect(read.faults).toEqual([{ code: 'not-in-convention', rows: [4] }]);
    expect(rowsOf(read.notices, 'odd-number')).toEqual([5]);
  });

  it('says that addresses look like numbers', () => {
    expect(codes(map('three-xxxx-in-address').notices)).toContain('addresses-like-numbers');
    expect(codes(map('three-xxxx-in-address').questions)).toContain('counting');
  });

  it('reads names with any separator, and keeps what is no name', () => {
    const [comma] = map('enum-comma').profile.registers;
    expect(comma?.names).toEqual([
      { number: 0, name: 'Cool' },
      { number: 1, name: 'Heat' },
      { number: 2, name: 'Auto' },
    ]);
    const rest = map('enum-one-bad-loses-row');
    expect(rest.profile.registers[0]?.names).toEqual([
      { number: 0, name: 'Off' },
      { number: 1, name: 'On' },
    ]);
    expect(rowsOf(rest.notices, 'names-rest')).toEqual([2]);
  });

  it('keeps a range as text', () => {
    const read = map('range-column');
    expect(read.profile.registers).toMatchObject([
      { name: 'Discharge temp', table: 'holding-register', address: 1010, names: [] },
    ]);
    expect(rowsOf(read.notices, 'range-kept')).toEqual([2]);
  });

  it('reads types and orders under other names', () => {
    expect(map('type-uint16').profile.registers.map(({ type }) => type)).toEqual(['u16', 'i32', 'f32', 'f32']);
    expect(map('type-bool').profile.registers).toMatchObject([{ table: 'coil', address: 0, type: 'bits' }]);
    expect(map('order-names').profile.registers.map(({ order }) => order)).toEqual(['CDAB', 'CDAB', 'BADC']);
  });

  it('takes a dash for no factor, and asks about x10', () => {
    const read = map('factor-dash');
    expect(read.profile.registers).toHaveLength(3);
    expect(codes(read.questions)).toContain('scale');
    expect(read.notices).toContainEqual({ code: 'assumed', question: 'scale', rows: [3] });
    const [, , half] = read.profile.registers;
    expect(namedValues({ ...read.profile, registers: [half!] }, 'holding-register', 2, [3])[0]?.scaled).toBe(1.5);
  });

  it('keeps registers of one name', () => {
    expect(places('name-repeats')).toEqual(['holding-register 100', 'holding-register 200', 'input-register 100']);
  });

  it('finds the header below a title, and in German', () => {
    expect(map('title-row').profile.registers).toMatchObject([{ name: 'A', table: 'holding-register', address: 0 }]);
    expect(map('german-header').columns.map(({ meaning }) => meaning)).toEqual([
      'address',
      'name',
      'type',
      'unit',
      'factor',
    ]);
  });

  it('takes a column called register for the number if its cells are numbers', () => {
    const read = map('register-is-number');
    expect(read.columns.slice(0, 2).map(({ meaning }) => meaning)).toEqual(['number', 'name']);
    expect(read.profile.registers).toMatchObject([{ name: 'Voltage', table: 'holding-register', address: 0 }]);
  });

  it('asks for the table where nothing names it', () => {
    const read = map('function-header');
    expect(read.profile.registers).toMatchObject([{ table: 'holding-register', address: 0 }]);
    expect(read.notices).toContainEqual({ code: 'assumed', question: 'table', rows: [2] });
    expect(map('function-header', { table: 'input-register' }).profile.registers).toMatchObject([
      { table: 'input-register' },
    ]);
  });

  it('reads the letters of Windows', () => {
    const bytes = Uint8Array.from(inputOf('latin1-unit').bytesLatin1 ?? '', (letter) => letter.charCodeAt(0));
    expect(readRegisterMap(bytes).profile.registers).toMatchObject([{ name: 'Vorlauf', unit: '°C' }]);
  });

  it('imports or counts every row with a broken quote', () => {
    const { profile, faults, notices } = map('broken-quotes-count');
    const lost = faults.flatMap(({ rows }) => rows);
    expect(profile.registers.length + lost.length).toBe(30);
    expect(new Set([...lost, ...(rowsOf(notices, 'quote-open') ?? [])]).size).toBe(30);
  });
});
