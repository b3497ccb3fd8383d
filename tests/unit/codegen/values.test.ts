import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { makePlan } from '../../../src/codegen/make-plan.ts';
import { settingsOf } from '../../../src/codegen/settings.ts';
import { builtInProfiles, type Profile, plainRegister, type Register, unitScale } from '../../../src/devices/index.ts';
import {
  encodeFrame,
  type FrameInput,
  fraction,
  type NumberTypeName,
  plainTypeNames,
  toRaw,
  writeValue,
} from '../../../src/modbus/index.ts';
import { holds, readingRequest, relations, type Sequence, type Until } from '../../../src/sequences/index.ts';
import { hex } from '../modbus/frames.ts';
import { Planned } from './planned.ts';
import { CodeRunner } from './run-code.ts';

const weg = builtInProfiles.find(({ id }) => id === 'weg-drive') as Profile;
const request = (functionCode: number, fields: FrameInput['fields']): FrameInput => ({
  transport: 'rtu',
  direction: 'request',
  unitId: 6,
  functionCode,
  fields,
});
const line = (name: string, address: number, parts: Partial<Register>): Register => ({
  ...plainRegister,
  name,
  table: 'holding-register',
  address,
  ...parts,
});
const device = (...registers: Register[]): Profile => ({
  id: 'a',
  name: 'a device',
  source: '',
  convention: 'six-digit',
  traits: [],
  registers,
  notes: [],
});

describe('values of a reply', () => {
  test('plain numbers of a reply are taken out: the event counter of AP 6.9', () => {
    const planned = new Planned(request(0x0b, {}));
    const reply = [6, 0x0b, 0xff, 0xff, 0x01, 0x08];
    const got = planned.request.values.map(({ name, routine }) => [name, planned.run(routine, reply)]);
    expect(got).toEqual([
      ['status', 0xffff],
      ['event count', 0x0108],
    ]);
  });

  test('a device has its values by name, in units where that is wanted', () => {
    const read = request(3, { startAddress: 681, quantity: 2 });
    // 4000 of 8192 for 60 Hz; the control word 3.
    const reply = hex('06 03 04 0F A0 00 03 00 00');
    const raw = new Planned(read, { profile: weg });
    expect(raw.request.values.map(({ name, unit, routine }) => [name, unit, raw.run(routine, [...reply])])).toEqual([
      ['p0681 actual speed', '', 4000],
      ['p0682 control word', '', 3],
    ]);
    const units = new Planned(read, { profile: weg, units: true });
    expect(
      units.request.values.map(({ name, unit, type, routine }) => [name, unit, type, units.run(routine, [...reply])]),
    ).toEqual([
      ['p0681 actual speed', 'Hz', 'real', 29.296875],
      ['p0682 control word', '', 'int', 3],
    ]);
  });

  const types = plainTypeNames.filter((type) => !['f64', 'u64', 'i64'].includes(type));
  test.each(types)('%s in every order', (type) => {
    const bcd = type === 'bcd16' || type === 'bcd32';
    const given =
      type === 'f32' || type === 'f16'
        ? [1.5, -0.25]
        : bcd
          ? [1234, 9]
          : type.startsWith('i')
            ? [-2, 1234]
            : [0xfedc, 1];
    for (const order of ['ABCD', 'CDAB', 'BADC', 'DCBA'] as const)
      for (const value of given) {
        const written = writeValue(value, type, order);
        if (written.kind !== 'registers') throw new Error('no registers');
        const profile = device(line('one', 0, { type, order }));
        const planned = new Planned(request(3, { startAddress: 0, quantity: written.registers.length }), { profile });
        const bytes = written.registers.flatMap((word) => [word >> 8, word & 0xff]);
        const [taken] = planned.request.values;
        expect(planned.run(taken?.routine ?? '', [6, 3, bytes.length, ...bytes])).toBe(value);
      }
  });

  test('rare types, parts of numbers, and powers of ten in other registers stand in the list only', () => {
    const profile = device(
      line('bytes', 0, { type: 'u8l' }),
      line('wide', 1, { type: 'u48' }),
      line('date', 4, { type: 'timeunix' }),
      line('address', 6, { type: 'ip' }),
      line('masked', 8, { mask: 0xff00 }),
      line('power', 9, { scaleRegister: { address: 8 }, unit: 'W' }),
      line('plain', 10, {}),
    );
    const { notes, request: planned } = new Planned(request(3, { startAddress: 0, quantity: 11 }), {
      profile,
      units: true,
    });
    expect(planned.values.map(({ name }) => name)).toEqual(['plain']);
    expect(notes.map(({ code, name }) => `${code} ${name}`)).toEqual(
      ['bytes', 'wide', 'date', 'address', 'masked', 'power'].map((name) => `raw-only ${name}`),
    );
  });

  test('text and 64 bits stand in the list only, and a note says so', () => {
    const profile = device(line('serial', 0, { type: 'text', count: 2 }), line('energy', 2, { type: 'u64' }));
    const { notes, request: planned } = new Planned(request(3, { startAddress: 0, quantity: 6 }), { profile });
    expect(planned.values).toEqual([]);
    expect(notes.map(({ code, name }) => [code, name])).toEqual([
      ['raw-only', 'serial'],
      ['raw-only', 'energy'],
    ]);
  });
});

describe('values that are written', () => {
  test('30 Hz is 4096 of a WEG drive, given in Hz', () => {
    const planned = new Planned(request(6, { address: 683, value: 4096 }), { profile: weg, units: true });
    const scaled = planned.request.arguments.find(({ parameter }) => parameter.name === 'value')?.scaled;
    expect(scaled).toEqual([{ index: 0, routine: 'hz to raw', value: 30, unit: 'Hz' }]);
    expect(planned.run('hz to raw', 30)).toBe(4096);
    expect(planned.run('hz to raw', -30)).toBe(0x1_0000 - 4096);
    expect([planned.run('hz to raw', 1e9), planned.run('hz to raw', -1e9)]).toEqual([0x7fff, 0x8000]);
  });

  test('decimals are rounded as the page rounds them, halves away from 0', () => {
    const factors = fc.constantFrom(1, 10, 100, 0.1, 0.5, 8192 / 60, 60 / 8192, 1 / 3, -10);
    fc.assert(
      fc.property(
        factors,
        fc.integer({ min: -300, max: 300 }),
        fc.integer({ min: -99_999, max: 99_999 }),
        (factor, offset, thousandths) => {
          const register = line('speed', 0, { type: 'i16', factor, offset, unit: 'Hz' });
          const scale = unitScale(register)?.scale;
          if (scale === undefined) throw new Error('no scale');
          const planned = new Planned(request(6, { address: 0, value: 0 }), { profile: device(register), units: true });
          const exact = toRaw(fraction(thousandths, 1000), scale);
          const raw = exact.kind === 'raw' ? Math.min(0x7fff, Math.max(-0x8000, Number(exact.raw))) : 0;
          expect(planned.run('hz to raw', thousandths / 1000)).toBe(raw & 0xffff);
        },
      ),
      { numRuns: 100 },
    );
  });

  test('what now stands in the register is what its value in units makes', () => {
    fc.assert(
      fc.property(fc.integer({ min: -0x8000, max: 0x7fff }), (raw) => {
        const planned = new Planned(request(6, { address: 683, value: raw & 0xffff }), { profile: weg, units: true });
        const [scaled] = planned.request.arguments.find(({ parameter }) => parameter.name === 'value')?.scaled ?? [];
        expect(planned.run('hz to raw', scaled?.value ?? 0)).toBe(raw & 0xffff);
      }),
    );
  });
});

describe('conditions of a sequence', () => {
  const until = (parts: Partial<Until>): Until => ({
    kind: 'until',
    unit: 6,
    table: 'holding-register',
    address: 681,
    type: 'i16',
    order: 'ABCD',
    relation: '≥',
    value: 4000,
    interval: 100,
    timeout: 5000,
    onFailure: 'stop',
    ...parts,
  });
  const planOf = (step: Until) => {
    const sequence: Sequence = { transport: 'rtu', steps: [step], finally: [] };
    const bytes = readingRequest(step, 'rtu');
    const [, functionCode = 0] = bytes;
    const input = request(functionCode, { startAddress: step.address, quantity: bytes[5] as number });
    const { plan } = makePlan([{ name: undefined, request: input }], settingsOf(), sequence);
    const [planned] = plan.sequence?.steps ?? [];
    if (planned?.kind !== 'until') throw new Error('no condition');
    return (words: readonly number[]) => {
      const data = words.flatMap((word) => [word >> 8, word & 0xff]);
      return new CodeRunner(plan.code).run(planned.holds, [6, functionCode, data.length, ...data]);
    };
  };

  test('hold as they do in the sequence, whatever the type, the order and the relation', () => {
    const whole: NumberTypeName[] = ['u16', 'i16', 'bits', 'u32', 'i32', 'bcd16', 'bcd32'];
    const any = fc.record({
      type: fc.constantFrom(...whole),
      order: fc.constantFrom('ABCD' as const, 'CDAB' as const, 'BADC' as const, 'DCBA' as const),
      relation: fc.constantFrom(...relations),
      got: fc.integer({ min: 0, max: 9999 }),
      value: fc.oneof(fc.integer({ min: -5, max: 9999 }), fc.constant(29.5)),
      same: fc.boolean(),
    });
    fc.assert(
      fc.property(any, ({ type, order, relation, got, value, same }) => {
        const step = until({ type, order, relation, value: same ? got : value });
        const written = writeValue(got, type, order);
        if (written.kind !== 'registers') throw new Error('no registers');
        expect(planOf(step)(written.registers)).toBe(holds(step, got));
      }),
      { numRuns: 70 },
    );
  });

  test.each([
    ['a float', until({ type: 'f32', relation: '=', value: 1.5 }), [0x3fc0, 0], true],
    ['a float that is no number', until({ type: 'f32', relation: '≠', value: 1.5 }), [0x7fc0, 0], false],
    ['a float of 64 bits', until({ type: 'f64', relation: '=', value: -118.625 }), [0xc05d, 0xa800, 0, 0], true],
    ['the least float of 64 bits', until({ type: 'f64', relation: '=', value: 5e-324 }), [0, 0, 0, 1], true],
    ['an infinite float of 16 bits', until({ type: 'f16', relation: '>', value: 1 }), [0x7c00], true],
    ['a float of 16 bits that is no number', until({ type: 'f16', relation: '≠', value: 1 }), [0x7e00], false],
    ['the least float of 16 bits', until({ type: 'f16', relation: '=', value: 2 ** -24 }), [1], true],
    ['a bit that is set', until({ bit: 3, relation: '=', value: 1 }), [8], true],
    ['a bit of two registers', until({ type: 'u32', bit: 31, relation: '=', value: 1 }), [0x8000, 0], true],
    ['a digit above 9', until({ type: 'bcd16', relation: '≠', value: 0 }), [0x000a], false],
    ['64 bits', until({ type: 'u64', relation: '=', value: 2 ** 40 + 1 }), [0, 0x100, 0, 1], true],
    ['the high bit of 64', until({ type: 'u64', bit: 63, relation: '=', value: 1 }), [0x8000, 0, 0, 0], true],
    [
      'the high bit of 64, low register first',
      until({ type: 'u64', order: 'CDAB', bit: 63, relation: '=', value: 1 }),
      [0, 0, 0, 0x8000],
      true,
    ],
  ] as const)('%s', (_, step, words, expected) => {
    expect(planOf(step)(words)).toBe(expected);
  });

  test('a coil', () => {
    const step = until({ table: 'coil', relation: '=', value: 1 });
    expect(encodeFrame(request(1, { startAddress: 681, quantity: 1 }))).toEqual(readingRequest(step, 'rtu'));
    expect([planOf(step)([0x0100]), planOf(step)([0x0000])]).toEqual([true, false]);
  });
});
