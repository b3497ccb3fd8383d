import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  compare,
  formatFraction,
  fraction,
  type NumberTypeName,
  numberTypeNames,
  numberTypes,
  type Order,
  orders,
  readValue,
  shortestFloat,
  unitsExactly,
} from '../../../../src/modbus/index.ts';
import { readExact, readValues, scaleOfUnit, type UnitScale, writeInUnits } from '../../../../src/notation/index.ts';

/** A drive whose 8192 stands for 60 Hz. */
const hertz: UnitScale = {
  unit: 'Hz',
  scale: { factor: fraction(60, 8192), offset: fraction(0), decimals: 1, least: fraction(0), most: fraction(60) },
  type: 'u16',
  order: 'ABCD',
};
const celsius: UnitScale = {
  unit: '°C',
  scale: { factor: fraction(1, 10), offset: fraction(-40), decimals: 1 },
  type: 'i16',
  order: 'ABCD',
};
const bar: UnitScale = {
  unit: 'bar',
  scale: { factor: fraction(1), offset: fraction(0), decimals: 2 },
  type: 'f32',
  order: 'CDAB',
};
const all = () => [hertz, celsius, bar];

const registersOf = (text: string) => {
  const { values, faults } = readValues(text, all);
  expect(faults).toEqual([]);
  return values.flatMap(({ registers }) => registers);
};

const faultsOf = (text: string, units = all) => readValues(text, units).faults.map(({ fault }) => fault);

describe('values in units become registers', () => {
  test.each<[string, number[]]>([
    // The guide's table of a drive: 8192 is full scale, 60 Hz.
    ['0 Hz', [0]],
    ['15 Hz', [2048]],
    ['30 Hz', [4096]],
    ['45 Hz', [6144]],
    ['60 Hz', [8192]],
    ['30.0 Hz', [4096]],
    ['30Hz', [4096]],
    ['30 hz', [4096]],
    ['15 Hz, 30 Hz\n45 Hz', [2048, 4096, 6144]],
    ['15 Hz 30 Hz', [2048, 4096]],
    ['50 Hz', [6827]],
    ['21.5 °C', [615]],
    ['-41 °C', [0xfff6]],
    ['21.5 bar', [0x0000, 0x41ac]],
    ['f32 ABCD 21.5 bar', [0x41ac, 0x0000]],
    ['u32 30 Hz', [0, 4096]],
    ['30 Hz, f32 CDAB 21.5, 15 Hz', [4096, 0x0000, 0x41ac, 2048]],
    ['16#1E Hz', [4096]],
  ])('%j', (text, registers) => {
    expect(registersOf(text)).toEqual(registers);
  });

  test('rounding is said, with what the number stands for', () => {
    const [value] = readValues('50 Hz', all).values;
    const [note] = value!.notes;
    if (note?.code !== 'in-units') throw new Error(note?.code);
    expect(note).toMatchObject({ typed: '50 Hz', inUnits: { raw: 6827, exact: false, unit: 'Hz' } });
    expect(formatFraction(note.inUnits.stands, 4)).toBe('50.0024');
    expect(readValues('30 Hz', all).values[0]?.notes).toMatchObject([{ inUnits: { raw: 4096, exact: true } }]);
    expect(value?.place).toEqual({ start: 0, end: 5 });
  });

  test('the units of a place are asked for by the registers before it', () => {
    const asked: number[] = [];
    readValues('30 Hz, f32 1, 30 Hz', (place) => {
      asked.push(place);
      return [hertz];
    });
    expect(asked).toEqual([0, 3]);
  });

  test('what cannot be written', () => {
    expect(faultsOf('60.1 Hz')).toMatchObject([{ code: 'outside-limits', typed: '60.1 Hz' }]);
    expect(faultsOf('-1 Hz')).toMatchObject([{ code: 'outside-limits', limits: { least: fraction(0) } }]);
    // i16 ends at 32767, which is 3236.7 °C.
    const [fault] = faultsOf('4000 °C');
    if (fault?.code !== 'outside-type') throw new Error(fault?.code);
    expect(fault).toMatchObject({ type: 'i16', raw: fraction(40400) });
    expect(formatFraction(fault.limits.most!, 1)).toBe('3236.7');
    expect(formatFraction(fault.limits.least!, 1)).toBe('-3316.8');
    expect(faultsOf('30 rpm')).toEqual([{ code: 'unit-unknown', unit: 'rpm', known: ['Hz', '°C', 'bar'] }]);
    expect(faultsOf('30 rpm', () => [])).toEqual([{ code: 'unit-unknown', unit: 'rpm', known: [] }]);
    expect(faultsOf('text 30 Hz')).toMatchObject([{ code: 'not-a-value' }]);
  });
});

test('units are known however they are written, unless two differ in their capitals alone', () => {
  const unit = (name: string): UnitScale => ({ ...hertz, unit: name });
  expect(scaleOfUnit('m3/h', [unit('m³/h')])?.unit).toBe('m³/h');
  // Micro sign and Greek mu.
  expect(scaleOfUnit('\u03bcA', [unit('\u00b5A')])?.unit).toBe('\u00b5A');
  expect(scaleOfUnit('ma', [unit('mA'), unit('MA')])).toBeUndefined();
  expect(scaleOfUnit('MA', [unit('mA'), unit('MA')])?.unit).toBe('MA');
});

test('what is written in units is read as what it stands for, in every type and order', () => {
  const scales = fc.record({
    factor: fc.tuple(fc.integer({ min: 1, max: 5000 }), fc.integer({ min: 1, max: 5000 })),
    offset: fc.integer({ min: 0, max: 50 }),
  });
  fc.assert(
    fc.property(
      fc.constantFrom<NumberTypeName>(...numberTypeNames),
      fc.constantFrom(...(Object.keys(orders) as Order[])),
      scales,
      fc.nat(400),
      (type, order, { factor, offset }, tenths) => {
        const scale = { factor: fraction(...factor), offset: fraction(offset), decimals: 3 };
        const known: UnitScale = { unit: 'x', scale, type, order };
        const value = fraction(tenths, 10);
        const written = writeInUnits(value, known);
        if (written.kind !== 'registers') {
          expect(written.kind).toBe('outside-type');
          return;
        }
        const held = readValue(written.registers, type, order);
        if (held.kind !== 'value' || typeof held.value === 'string') throw new Error(held.kind);
        const float = numberTypes[type].kind === 'float';
        const raw = float ? readExact(shortestFloat(Number(held.value), type))!.exactly : fraction(held.value);
        const read = unitsExactly(raw, scale);
        expect(compare(read, written.inUnits.stands)).toBe(0);
        expect(compare(read, value) === 0).toBe(written.inUnits.exact);
        // Half a step is the most that rounding to a whole number takes away.
        const step = unitsExactly(fraction(offset + 1), scale);
        const off = Math.abs(tenths / 10 - Number(read.numerator) / Number(read.denominator));
        const most = type.startsWith('f') ? Math.abs(tenths / 10) * 1e-3 + 60 * (factor[1] / factor[0]) * 1e-3 : 0;
        expect(off).toBeLessThanOrEqual((Number(step.numerator) / Number(step.denominator) / 2) * 1.000001 + most);
      },
    ),
    { numRuns: 1000 },
  );
});
