import fc from 'fast-check';
import { describe, expect, it, test } from 'vitest';
import {
  exactlyInUnits,
  namedValues,
  type Profile,
  plainRegister,
  type Register,
  ratioText,
  readDevice,
  readProfiles,
  readRatio,
  readTable,
  scaleOf,
  unitScale,
  withScale,
  writeDevice,
  writeProfiles,
  writeTable,
} from '../../../src/devices/index.ts';
import { compare, divide, exactFraction, fraction, simplestFraction, subtract } from '../../../src/modbus/index.ts';

const line = (more: Partial<Register> = {}): Register => ({
  ...plainRegister,
  table: 'holding-register',
  name: 'A',
  address: 0,
  ...more,
});
const device = (...registers: readonly Register[]): Profile => ({
  id: 'x',
  name: 'X',
  source: '',
  convention: 'zero-based',
  traits: [],
  registers,
  notes: [],
});
const rowsOf = (...cells: readonly (readonly string[])[]) => cells.map((row, at) => ({ line: at + 1, cells: row }));
const scaledOf = (register: Register, ...list: readonly number[]) =>
  namedValues(device(register), 'holding-register', 0, list)[0]?.scaled;

describe('a value is raw × factor + offset', () => {
  it.each([
    [{ factor: 0.1 }, 490, 49],
    [{ factor: 0.1, offset: -40 }, 615, 21.5],
    [{ factor: 60 / 8192 }, 4096, 30],
    [{ factor: 10 }, 3, 30],
    [{ factor: 1e-7, type: 'i32' }, 0, 0],
    [{ factor: 1 / 3 }, 3, 1],
  ] as readonly [Partial<Register>, number, number][])('%j: %d is %d', (more, raw, value) => {
    const words = more.type === 'i32' ? [0, raw] : [raw];
    expect(scaledOf(line(more), ...words)).toBe(value);
  });

  it('is exact for 64 bits, beyond what a double holds', () => {
    const energy = line({ type: 'u64', factor: 0.001, unit: 'kWh' });
    const [value] = namedValues(device(energy), 'holding-register', 0, [32, 0, 0, 1]);
    expect(value?.exactly).toEqual(fraction(9007199254740993n, 1000n));
  });
});

/** What each form of a file says of one register of the old meaning: raw = value × factor + offset. */
const oldForms = (factor: number, offset: number): Readonly<Record<string, Register | undefined>> => {
  const registers = [{ name: 'A', table: 'holding-register', address: 0, factor, offset, unit: 'V' }];
  const profile = { id: 'x', name: 'X', source: '', convention: 'zero-based', registers };
  const json = readProfiles(JSON.stringify({ format: 'framewright-devices', version: 1, profiles: [profile] }));
  const head = ['name', 'table', 'address', 'factor', 'offset', 'unit'];
  const row = ['A', 'holding-register', '0', String(factor), String(offset), 'V'];
  const table = readTable(rowsOf(['#id', 'x'], ['#convention', 'zero-based'], head, row), 'file');
  return {
    json: json.kind === 'profiles' ? json.profiles[0]?.profile.registers[0] : undefined,
    table: table.profile.registers[0],
    link: readDevice(JSON.stringify([1, 'X', 0, 0, [], [[0, 'A', 3, 0, 'V', factor, offset]]]), 'x')?.registers[0],
  };
};

test('a raw number stands for the same value as before, exactly, whatever form its device was kept in', () => {
  const size = fc.double({ min: 1e-9, max: 1e9, noNaN: true });
  const factors = fc.oneof(
    size,
    size.map((n) => -n),
    fc.constantFrom(10, 0.1, 3, 7, 8192 / 60, 0.0001234567, 1e21),
  );
  const offsets = fc.oneof(fc.integer(), fc.double({ min: -1e6, max: 1e6, noNaN: true }), fc.constant(0));
  fc.assert(
    fc.property(factors, offsets, fc.nat(65535), (factor, offset, raw) => {
      // Exactly as version 1 had it.
      const before = divide(subtract(fraction(raw), simplestFraction(offset)), simplestFraction(factor));
      for (const [form, register] of Object.entries(oldForms(factor, offset))) {
        const after = exactlyInUnits(raw, register!);
        expect([form, compare(after, before)]).toEqual([form, 0]);
        // And again, once it was written in today's version.
        const json = readProfiles(writeProfiles([device(register!)]));
        const again = [
          json.kind === 'profiles' ? json.profiles[0]?.profile.registers[0] : undefined,
          readTable(rowsOf(...writeTable(device(register!))), 'file').profile.registers[0],
          readDevice(writeDevice(device(register!)), 'x')?.registers[0],
        ];
        for (const one of again) expect(compare(exactlyInUnits(raw, one!), before)).toBe(0);
      }
    }),
    { numRuns: 200 },
  );
});

describe('which meaning a table has', () => {
  const head = ['name', 'table', 'address', 'factor'];
  const row = ['A', 'holding', '0', '10'];
  const factorOf = (...settings: readonly (readonly string[])[]) =>
    readTable(rowsOf(...settings, head, row), 'file').profile.registers[0]?.factor;

  it('is the old one with both #id and #convention, and no #version', () => {
    expect(factorOf(['#id', 'x'], ['#convention', 'zero-based'])).toBe(0.1);
    expect(factorOf(['#version', '1'])).toBe(0.1);
  });

  it('is the field’s in every other table', () => {
    expect(factorOf()).toBe(10);
    expect(factorOf(['#id', 'x'])).toBe(10);
    expect(factorOf(['#convention', 'zero-based'])).toBe(10);
    expect(factorOf(['#version', '2'], ['#id', 'x'], ['#convention', 'zero-based'])).toBe(10);
  });

  it('is said in what is written', () => {
    expect(writeTable(device(line()))[0]).toEqual(['#version', '2']);
    expect(JSON.parse(writeProfiles([device(line())]))).toMatchObject({ version: 2 });
    expect(JSON.parse(writeDevice(device(line())))[0]).toBe(2);
  });

  it('tells a version that nobody knows', () => {
    const { faults } = readTable(rowsOf(['#version', '9'], head, row), 'file');
    expect(faults).toMatchObject([{ code: 'setting-unreadable', setting: '#version', got: '9' }]);
  });
});

test('a factor that no number holds is kept as a quotient', () => {
  const scale = { factor: fraction(10n ** 10n, 1234567n), offset: fraction(-(10n ** 16n) - 1n, 3n) };
  const register = line({ ...withScale(scale), unit: 'V' });
  expect(register.exact).toEqual({ factor: '10000000000/1234567', offset: '-10000000000000001/3' });
  expect(scaleOf(register)).toEqual(scale);
  expect(unitScale(register)?.scale).toMatchObject(scale);
  expect(withScale({ factor: fraction(1, 3), offset: fraction(0) })).toEqual({ factor: 1 / 3, offset: 0 });
});

test('factors as they are typed', () => {
  for (const [text, value] of [
    ['0,1', fraction(1, 10)],
    ['.5', fraction(1, 2)],
    ['-,5', fraction(-1, 2)],
    ['60/8192', fraction(15, 2048)],
    ['1e-3', fraction(1, 1000)],
    ['1/10', fraction(1, 10)],
    ['1/0', undefined],
    ['x10', undefined],
    ['0x10', undefined],
    ['1.', undefined],
  ] as const)
    expect([text, readRatio(text)]).toEqual([text, value]);
  for (const [value, text] of [
    [fraction(1, 10), '0.1'],
    [fraction(15, 2048), '15/2048'],
    [fraction(1, 3), '1/3'],
    [fraction(-40), '-40'],
  ] as const)
    expect(ratioText(value)).toBe(text);
});

describe('a scale register', () => {
  const power = line({ name: 'W', scaleRegister: { address: 1 }, unit: 'W' });

  it('multiplies by the power of ten that it holds', () => {
    // SunSpec model 103: W = 5003, W_SF = −2.
    expect(scaledOf(power, 5003, 65534)).toBe(50.03);
    expect(scaledOf(power, 5003, 2)).toBe(500300);
    expect(scaledOf({ ...power, factor: 0.5 }, 5003, 65535)).toBe(250.15);
  });

  it('leaves the value open where it is not read with it, or says nothing', () => {
    expect(scaledOf(power, 5003)).toBeUndefined();
    // 0x8000 is “not implemented”.
    expect(scaledOf(power, 5003, 0x8000)).toBeUndefined();
    expect(unitScale(power)).toBeUndefined();
  });
});

it('says that the device has no such value', () => {
  const none = (more: Partial<Register>, ...words: readonly number[]) =>
    namedValues(device(line(more)), 'holding-register', 0, words)[0];
  expect(none({ type: 'i16', notImplemented: '0x8000' }, 0x8000)).toMatchObject({ notImplemented: true });
  expect(none({ type: 'i16', notImplemented: '0x8000' }, 0x8000)?.scaled).toBeUndefined();
  expect(none({ notImplemented: '65535' }, 65535)).toMatchObject({ notImplemented: true });
  expect(none({ type: 'f32', notImplemented: 'NaN' }, 0x7fc0, 0)).toMatchObject({ notImplemented: true });
  expect(none({ type: 'i64', notImplemented: '0x8000000000000000' }, 0x8000, 0, 0, 0)?.notImplemented).toBe(true);
  expect(none({ type: 'i16', notImplemented: '0x8000' }, 7)).toMatchObject({ scaled: 7 });
  for (const notImplemented of ['0x', '0x80G0', 'none'])
    expect(none({ notImplemented }, 7), notImplemented).toMatchObject({ scaled: 7 });
});

it('takes the bits of a mask, moved down', () => {
  expect(scaledOf(line({ mask: 0xff00 }), 0x191e)).toBe(0x19);
  expect(scaledOf(line({ mask: 0x00ff }), 0x191e)).toBe(30);
  expect(scaledOf(line({ mask: 0x0010 }), 0x191e)).toBe(1);
  expect(scaledOf(line({ type: 'i16', mask: 0x8000 }), 0x8000)).toBe(1);
  // A number with decimals has no bits of its own: 1.5 is 3FC0 0000.
  expect(scaledOf(line({ type: 'f32', mask: 1 }), 0x3fc0, 0)).toBe(1.5);
});

test('what is rare in a register is kept in a table, in JSON and in a link', () => {
  const rare = line({
    ...withScale({ factor: fraction(10n ** 10n, 1234567n), offset: fraction(0) }),
    scaleRegister: { address: 0 },
    notImplemented: '0x8000',
    mask: 0xff00,
    group: 'Meter; 1',
    models: ['X1', 'X2'],
  });
  const profile = device(rare, line({ name: 'B', address: 1 }));
  expect(readTable(rowsOf(...writeTable(profile)), 'file')).toEqual({ profile, faults: [] });
  expect(readProfiles(writeProfiles([profile]))).toEqual({ kind: 'profiles', profiles: [{ profile, faults: [] }] });
  expect(readDevice(writeDevice(profile), 'x')).toEqual(profile);
  // Columns that nothing stands in are not written.
  expect(writeTable(device(line())).at(-2)).not.toContain('mask');
});

test('a double is a fraction exactly', () => {
  expect(exactFraction(0.5)).toEqual(fraction(1, 2));
  expect(exactFraction(0.1).denominator).toBe(2n ** 55n);
  expect(() => exactFraction(Number.NaN)).toThrow(RangeError);
});
