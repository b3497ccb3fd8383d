import { describe, expect, it } from 'vitest';
import {
  builtInProfiles,
  isProfile,
  type Profile,
  plainRegister,
  readProfiles,
  writeProfiles,
} from '../../../src/devices/index.ts';
import { pump } from './pump.ts';

const register = { ...plainRegister, name: 'Level', table: 'holding-register', address: 1 } as const;
const withRegister = (change: Readonly<Record<string, unknown>>) => ({
  ...pump,
  registers: [{ ...register, ...change }],
});

describe('a value that is a profile as it stands', () => {
  it.each(builtInProfiles.map((profile) => [profile.name, profile]))('is read as itself: %s', (_, profile) => {
    expect(isProfile(profile)).toBe(true);
    const reading = readProfiles(writeProfiles([profile]));
    expect(reading).toMatchObject({ kind: 'profiles', profiles: [{ faults: [] }] });
  });

  it.each([
    ['exact', { factor: '1000/123457', offset: '0' }],
    ['scaleRegister', { address: 0xffff }],
    ['notImplemented', '0x8000'],
    ['mask', 0xff00],
    ['decimals', 10],
    ['names', [{ number: -1, name: 'off' }]],
    ['group', 'Heating'],
    ['models', ['X1']],
  ])('may have %s', (key, value) => {
    expect(isProfile(withRegister({ [key]: value }))).toBe(true);
  });

  it.each([
    ['name', 7],
    ['table', 'file-record'],
    ['table', 'constructor'],
    ['address', -1],
    ['address', 0x10000],
    ['address', 1.5],
    ['address', '1'],
    ['type', 'toString'],
    ['order', 'ABBA'],
    ['count', 0],
    ['count', 0x10001],
    ['factor', 0],
    ['factor', Number.NaN],
    ['factor', '1'],
    ['offset', Number.POSITIVE_INFINITY],
    ['exact', { factor: 'x', offset: '0' }],
    ['exact', { factor: '1' }],
    ['scaleRegister', 3],
    ['notImplemented', 0],
    ['mask', 0],
    ['unit', undefined],
    ['decimals', 11],
    ['access', 'x'],
    ['names', [{ number: 1.5, name: 'half' }]],
    ['names', [{ number: 1 }]],
    ['names', 'none'],
    ['description', null],
    ['group', 1],
    ['models', 'X1'],
  ])('has no register with %s %j', (key, value) => {
    expect(isProfile(withRegister({ [key]: value }))).toBe(false);
  });

  it.each<[keyof Profile, unknown]>([
    ['id', ''],
    ['name', ''],
    ['source', 1],
    ['convention', 'constructor'],
    ['serial', { baud: -1, dataBits: 8, parity: 'even', stopBits: 1 }],
    ['serial', { baud: '9600', dataBits: 8, parity: 'even', stopBits: 1 }],
    ['traits', ['own']],
    ['registers', {}],
    ['registers', [null]],
    ['notes', [1]],
    ['answers', ['one']],
    ['answers', { counting: 1 }],
  ])('has no %s %j', (key, value) => {
    expect(isProfile({ ...pump, [key]: value })).toBe(false);
  });

  it.each([[undefined], [null], [7], ['profile'], [[]], [{}]])('is not %j', (value) => {
    expect(isProfile(value)).toBe(false);
  });
});
