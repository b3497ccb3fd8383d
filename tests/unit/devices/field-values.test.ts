import { describe, expect, it } from 'vitest';
import { namedValues, type Profile, plainRegister, readRegisterMap } from '../../../src/devices/index.ts';
import { formatFraction, readValue } from '../../../src/modbus/index.ts';
import { findExpected, readAddress, readExpected, readValues } from '../../../src/notation/index.ts';
import cases from '../../vectors/field-maps.json' with { type: 'json' };

/** What people had before them, and what is right: values and addresses of tests/vectors/field-maps.json. */
interface Input {
  readonly text?: string;
  readonly registers?: readonly number[];
}
const input = (id: string): Required<Input> => {
  const found = cases.find((each) => each.id === id)?.input as Input | undefined;
  if (found === undefined) throw new RangeError(`no input ${id}`);
  return { text: '', registers: [], ...found };
};
const found = (id: string) => {
  const { registers, text } = input(id);
  return findExpected(registers, readExpected(text)!).map(({ at, view: { type, order } }) => `${at} ${type} ${order}`);
};

describe('values and addresses from the field', () => {
  it.each([
    ['mod10k', '0 mod10k4 CDAB'],
    ['high-and-low-byte', '0 u8l ABCD'],
    ['exponent-mantissa', '0 e8m24 ABCD'],
    ['order-64-mixed', '0 u64 EFGHABCD'],
  ])('%s is found', (id, where) => {
    expect(found(id)).toContain(where);
  });

  it('a scale factor of SunSpec stands in a register of its own', () => {
    const w = { ...plainRegister, name: 'W', table: 'holding-register', address: 0, type: 'i16' } as const;
    const profile: Profile = {
      ...{ id: '', name: 'x', source: '', convention: 'zero-based', traits: [], notes: [] },
      registers: [{ ...w, scaleRegister: { address: 1 } }],
    };
    const { registers } = input('sunspec-scale-factor');
    expect(namedValues(profile, 'holding-register', 0, registers)[0]?.scaled).toBe(50.03);
  });

  it('texts end at their first NUL, and are UTF-8', () => {
    expect(readValue(input('text-nul-inside').registers, 'text', 'ABCD')).toEqual({ kind: 'value', value: 'ABC' });
    expect(readValue(input('text-utf8').registers, 'text', 'ABCD')).toEqual({ kind: 'value', value: 'Küche' });
  });

  it('bits of 32 have names', () => {
    const { text, registers } = input('u32-status-bits');
    const { profile } = readRegisterMap(text);
    expect(namedValues(profile, 'holding-register', 0, registers)[0]?.names).toContain('F17');
  });

  it('64 bits are scaled exactly', () => {
    const { text, registers } = input('u64-scaled-precision');
    const { profile } = readRegisterMap(text);
    const [value] = namedValues(profile, 'holding-register', 0, registers);
    expect(value?.exactly && formatFraction(value.exactly, 3)).toBe('9007199254740.993');
  });

  it('typed values: a decimal comma, and hexadecimal of a signed type', () => {
    expect(readValues(input('typed-comma').text)).toMatchObject({
      values: [],
      notices: [{ code: 'decimal-comma', read: '21.5' }],
    });
    expect(readValues(input('hex-to-signed').text).values).toMatchObject([{ value: -1, registers: [0xffff] }]);
  });

  it.each([
    ['addr-bit-suffix', { table: 'holding-register', address: 0, bit: 5 }],
    ['addr-range', { table: 'holding-register', address: 0, quantity: 2 }],
    ['addr-plc-devices', { plc: 'directlogic', address: 1024 }],
    ['addr-hex-h-prefix', { address: 0x1000 }],
  ])('%s is read', (id, expected) => {
    expect(readAddress(input(id).text, 'digits', 'holding-register')[0]).toMatchObject(expected);
  });
});
