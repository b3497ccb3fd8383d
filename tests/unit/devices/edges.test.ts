import { describe, expect, it } from 'vitest';
import {
  builtInProfiles,
  type Profile,
  type ProfilesReading,
  type Register,
  readProfiles,
  readTable,
  type TableRow,
} from '../../../src/devices/index.ts';
import { indexOfName, isCalled, lineName, valueName } from '../../../src/devices/numbering.ts';
import { searchProfile } from '../../../src/devices/search.ts';

const rowsOf = (...rows: readonly (readonly string[])[]): TableRow[] =>
  rows.map((cells, index) => ({ line: index + 1, cells }));

/** The one line of a table with these cells. */
const lineOf = (cells: Readonly<Record<string, string>>, ...settings: readonly (readonly string[])[]) => {
  const full = { name: 'Line', table: 'holding-register', address: '5', ...cells };
  const { profile, faults } = readTable(rowsOf(...settings, Object.keys(full), Object.values(full)), 'file');
  return { register: profile.registers[0], faults, profile };
};
const register = (cells: Readonly<Record<string, string>>): Register => {
  const { register: found, faults } = lineOf(cells);
  expect(faults).toEqual([]);
  if (found === undefined) throw new Error('no register');
  return found;
};

describe('cells', () => {
  it.each([
    ['0,1', 0.1],
    [' 8192 / 64 ', 128],
    ['1e-3', 0.001],
    ['-2.5', -2.5],
    ['1/2/3', undefined],
    ['1/0', undefined],
    ['x', undefined],
    ['1.', undefined],
  ])('a factor of "%s"', (factor, value) => {
    const { register: found, faults } = lineOf({ factor });
    if (value === undefined) expect(faults).toMatchObject([{ code: 'cell-not-a-number', column: 'factor' }]);
    else expect(found?.factor).toBe(value);
  });

  it.each([
    [
      '0=off; 1=on',
      [
        { number: 0, name: 'off' },
        { number: 1, name: 'on' },
      ],
    ],
    [
      '0: off;; 1 = a\\;b ;',
      [
        { number: 0, name: 'off' },
        { number: 1, name: 'a;b' },
      ],
    ],
    ['', []],
  ])('names "%s"', (names, expected) => {
    expect(register({ names }).names).toEqual(expected);
  });
  it.each(['off', '=off', '0=', '1.5=x', '0=off; on'])('names that cannot be read: "%s"', (names) => {
    expect(lineOf({ names }).faults).toEqual([{ code: 'names-unreadable', got: names, line: 2 }]);
  });

  it.each([
    ['five-digit', '40108', 'holding-register', 107],
    ['five-digit', '400108', 'holding-register', 107],
    ['one-based', '1', undefined, 0],
    ['zero-based', '0', undefined, 0],
    ['zero-based', '65535', undefined, 65535],
    ['one-based', '65536', undefined, 65535],
    // Five digits are a number like any other where the manual does not count so.
    ['one-based', '40108', undefined, 40107],
    ['zero-based', '300001', 'input-register', 0],
  ])('in a %s manual, number %s', (convention, number, table, address) => {
    const { register: found, faults } = lineOf({ address: '', number, table: table ?? 'holding-register' }, [
      '#convention',
      convention,
    ]);
    expect(faults).toEqual([]);
    expect(found).toMatchObject({ address, table: table ?? 'holding-register' });
  });
  it.each([
    ['one-based', '0', { code: 'cell-out-of-range', least: 1, most: 65536 }],
    ['zero-based', '65536', { code: 'cell-out-of-range', least: 0, most: 65535 }],
    ['five-digit', '40000', { code: 'cell-out-of-range', column: 'number', got: 0 }],
    ['one-based', '1.5', { code: 'cell-out-of-range', got: 1.5 }],
    ['one-based', 'x40108', { code: 'cell-not-a-number', column: 'number', got: 'x40108' }],
    ['five-digit', '30001', { code: 'number-of-other-table', got: '30001', table: 'input-register' }],
  ])('in a %s manual, number %s is refused', (convention, number, fault) => {
    expect(lineOf({ address: '', number }, ['#convention', convention]).faults).toMatchObject([fault]);
  });
});

describe('the serial line of a device', () => {
  const serialOf = (...texts: readonly string[]) => lineOf({}, ['#serial', ...texts]);

  it.each([
    [['9600', '8', 'none', '1'], { baud: 9600, dataBits: 8, parity: 'none', stopBits: 1 }],
    [['9600', '7', 'EVEN', '2', '0'], { baud: 9600, dataBits: 7, parity: 'even', stopBits: 2, unit: 0 }],
    [['1', '8', 'odd', '1', '255'], { baud: 1, dataBits: 8, parity: 'odd', stopBits: 1, unit: 255 }],
  ])('%j', (texts, serial) => {
    const { profile, faults } = serialOf(...texts);
    expect(faults).toEqual([]);
    expect(profile.serial).toEqual(serial);
  });
  it.each([
    [['0', '8', 'none', '1']],
    [['9600.5', '8', 'none', '1']],
    [['9600', '9', 'none', '1']],
    [['9600', '8', 'mark', '1']],
    [['9600', '8', 'none', '3']],
    [['9600', '8', 'none', '1', '-1']],
    [['9600', '8', 'none', '1', '256']],
    [['9600', '8', 'none', '1', '1.5']],
    [['9600', '8', 'none', '1', 'x']],
    [[]],
  ])('%j is refused', (texts) => {
    const { profile, faults } = serialOf(...texts);
    expect(profile.serial).toBeUndefined();
    expect(faults).toMatchObject([{ code: 'setting-unreadable' }]);
  });
});

describe('addresses that look like numbers', () => {
  const codes = (...addresses: readonly string[]) =>
    readTable(
      rowsOf(['name', 'table', 'address'], ...addresses.map((one, i) => [`R${i}`, 'holding-register', one])),
      'file',
    ).faults.map(({ code }) => code);

  it('are told where all of them do', () => {
    expect(codes('40001', '49999')).toEqual(['addresses-like-numbers']);
    expect(codes('40000', '40002')).toEqual([]);
    expect(codes('40001', '50000')).toEqual([]);
    expect(codes()).toEqual([]);
  });
});

describe('a file of profiles', () => {
  const why = (text: string) => {
    const read: ProfilesReading = readProfiles(text);
    return read.kind === 'unreadable' ? read.fault : undefined;
  };
  const file = (profile: unknown) => {
    const read = readProfiles(JSON.stringify({ format: 'framewright-devices', version: 1, profiles: [profile] }));
    if (read.kind !== 'profiles') throw new Error(read.fault.code);
    return read.profiles[0];
  };

  it('is refused for what it is not', () => {
    expect(why('{')).toMatchObject({ code: 'not-json', detail: expect.stringMatching(/JSON/) });
    for (const text of [
      'null',
      '[]',
      '{}',
      '{"format":"framewright-devices"}',
      '{"format":"x","version":1,"profiles":[]}',
    ]) {
      expect(why(text), text).toEqual({ code: 'not-profiles' });
    }
    expect(why('{"format":"framewright-devices","version":"1","profiles":[]}')).toEqual({ code: 'not-profiles' });
    expect(why('{"format":"framewright-devices","version":1,"profiles":{}}')).toEqual({ code: 'not-profiles' });
    expect(why('{"format":"framewright-devices","version":1,"profiles":[1]}')).toEqual({ code: 'not-profiles' });
    expect(why('{"format":"framewright-devices","version":3,"profiles":[]}')).toEqual({
      code: 'newer-version',
      version: 3,
    });
    expect(readProfiles('\uFEFF{"format":"framewright-devices","version":1,"profiles":[]}').kind).toBe('profiles');
  });
  it('says what of a profile cannot be read, and keeps the rest', () => {
    const read = file({
      name: ' Pump ',
      convention: 'octal',
      traits: ['x'],
      notes: 'one',
      serial: [],
      registers: [1],
      source: 7,
    });
    expect(read?.profile).toMatchObject({
      name: 'Pump',
      convention: 'zero-based',
      traits: [],
      notes: [],
      registers: [],
      source: '7',
    });
    expect(read?.faults.map((fault) => ('setting' in fault ? fault.setting : fault.code))).toEqual([
      'convention',
      'serial',
      'trait',
      'notes',
      'not-a-row',
    ]);
    expect(file({ name: ' ', convention: 'zero-based' })?.faults).toMatchObject([{ setting: 'name', got: '" "' }]);
  });
});

describe('names and searches', () => {
  it('a series is called by its numbers, in decimal and hexadecimal', () => {
    const lines = builtInProfiles.flatMap((profile) => profile.registers.map((one) => ({ profile, one })));
    const series = lines.filter(({ one }) => one.type !== 'text' && one.count > 2 && lineName(one) !== one.name);
    expect(series.length).toBeGreaterThan(3);
    for (const { one } of series) {
      expect(lineName(one)).toBe(`${valueName(one, 0)} … ${valueName(one, one.count - 1)}`);
      expect(indexOfName(one, valueName(one, one.count - 1)), one.name).toBe(one.count - 1);
      expect(indexOfName(one, `${valueName(one, 0)}0x`), one.name).toBeUndefined();
    }
  });
  it('a name that begins with a code is called by the code', () => {
    const line = { ...register({}), name: 'P0683 Control word' };
    expect(isCalled(line, 'p 0683')).toBe(true);
    expect(isCalled(line, 'P0683 control WORD')).toBe(true);
    expect(isCalled(line, 'P068')).toBe(false);
    expect(isCalled(line, '')).toBe(false);
    expect(isCalled({ ...line, name: 'Speed 2' }, 'speed')).toBe(false);
    expect(isCalled({ ...line, name: 'AB12C code' }, 'ab12c')).toBe(false);
  });
  it('finds by words, addresses and printed numbers', () => {
    const line = register({ name: 'Pressure', unit: 'bar', address: '107' });
    const profile: Profile = { ...lineOf({}).profile, convention: 'five-digit', registers: [line] };
    const found = (text: string) => searchProfile(profile, text).length;
    for (const text of ['', ' ', 'press', 'BAR', 'holding', '107', '0x6B', '40108']) expect(found(text), text).toBe(1);
    for (const text of ['106', '40107', '30108', 'x40108', '108.5', 'volt']) expect(found(text), text).toBe(0);
    // A manual that prints addresses: people look for its registers by numbers all the same.
    for (const text of ['107', '40108', '400108'])
      expect(searchProfile({ ...profile, convention: 'zero-based' }, text), text).toHaveLength(1);
    expect(searchProfile({ ...profile, convention: 'one-based' }, '108')).toHaveLength(1);
  });
});
