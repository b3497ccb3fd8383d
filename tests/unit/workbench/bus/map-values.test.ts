import { describe, expect, it } from 'vitest';
import { builtInProfiles, type Profile, plainRegister, type Register } from '../../../../src/devices/index.ts';
import { mapValues, type ReadCell, readableValues } from '../../../../src/workbench/bus/map-values.ts';

const [any] = builtInProfiles;
const line: Register = { ...plainRegister, name: 'one', table: 'holding-register', address: 100 };
const found = (register: Register, index?: number) => ({ register, index });
const profile = any as Profile;
const cells = (entries: Readonly<Record<string, readonly number[] | undefined>>) =>
  new Map<string, ReadCell>(
    Object.entries(entries).map(([key, items]) => [
      key,
      items ? { time: 5, items } : { time: 5, failure: { outcome: 'silent', verdict: 'bad' } },
    ]),
  );

describe('the lines of a map that can be read', () => {
  it('are read value by value, a text as one, and not those that can only be written', () => {
    const series = { ...line, count: 3 };
    const lines = [
      found(line),
      found({ ...line, access: 'w' }),
      found(series),
      found({ ...line, type: 'text', count: 8 }),
    ];
    expect(readableValues(lines).map(({ register, index }) => [register.type, register.count, index])).toEqual([
      ['u16', 1, 0],
      ['u16', 3, 0],
      ['u16', 3, 1],
      ['u16', 3, 2],
      ['text', 8, 0],
    ]);
    expect(readableValues([found(series, 2)])).toEqual([{ register: series, index: 2 }]);
  });
});

describe('what was read of a line', () => {
  it('is its value, in its type and order, and changes when these do', () => {
    const read = cells({ 'holding-register 100 2': [0x0001, 0x0002] });
    const raw = (more: Partial<Register>) => mapValues(profile, found({ ...line, ...more }), read);
    expect(raw({ type: 'u32' })).toEqual([{ kind: 'value', raw: 0x10002, power: undefined, time: 5 }]);
    expect(raw({ type: 'u32', order: 'CDAB' })).toMatchObject([{ raw: 0x20001 }]);
    // One register of the two is another place: it was not read as such.
    expect(raw({ type: 'u16' })).toEqual([]);
  });

  it('has the power of ten of its scale register, or why there is no value', () => {
    const scaled = { ...line, scaleRegister: { address: 110 } };
    const one = { 'holding-register 100 1': [5003] };
    expect(mapValues(profile, found(scaled), cells({ ...one, 'holding-register 110 1': [0xfffe] }))).toMatchObject([
      { raw: 5003, power: -2 },
    ]);
    expect(mapValues(profile, found(scaled), cells({ ...one, 'holding-register 110 1': undefined }))).toMatchObject([
      { raw: 5003, power: undefined },
    ]);
    expect(mapValues(profile, found(scaled), cells({ 'holding-register 100 1': undefined }))).toEqual([
      { kind: 'failed', failure: { outcome: 'silent', verdict: 'bad' }, time: 5 },
    ]);
  });

  it('is its first four values where it has many, or the one that was found', () => {
    const read = cells(Object.fromEntries([0, 1, 2, 3, 4].map((at) => [`holding-register ${100 + at} 1`, [at]])));
    const raws = (index?: number) =>
      mapValues(profile, found({ ...line, count: 5 }, index), read).map((value) => value.kind === 'value' && value.raw);
    expect(raws()).toEqual([0, 1, 2, 3]);
    expect(raws(4)).toEqual([4]);
  });

  it('is a bit of a table of bits, and no value where the registers hold none', () => {
    const coil = { ...line, table: 'coil', type: 'bits' } as const;
    expect(mapValues(profile, found(coil), cells({ 'coil 100 1': [1] }))).toMatchObject([{ raw: 1 }]);
    expect(
      mapValues(profile, found({ ...line, type: 'bcd16' }), cells({ 'holding-register 100 1': [0x12a4] })),
    ).toMatchObject([{ kind: 'value', raw: undefined }]);
  });
});
