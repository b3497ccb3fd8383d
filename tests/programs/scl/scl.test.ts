import { describe, expect, test } from 'vitest';
import { makePlan } from '../../../src/codegen/make-plan.ts';
import { writeFor } from '../../../src/codegen/program.ts';
import { settingsOf } from '../../../src/codegen/settings.ts';
import { scl } from '../../../src/codegen/targets/scl.ts';
import { encodeFrame } from '../../../src/modbus/index.ts';
import { programCases, repliesTo, sequences } from '../cases.ts';
import { Machine } from '../structured-text/machine.ts';
import { asStructuredText, SclFault } from './scl-rules.ts';

const [motor] = sequences;
const sclOf = (...[what, options]: [Parameters<typeof writeFor>[1], Parameters<typeof writeFor>[2]?]) =>
  writeFor(scl, what, options).files[0]?.text ?? '';

describe.each(['rtu', 'ascii', 'tcp'] as const)('SCL over %s', (transport) => {
  test.each(programCases(transport, 5))('$name keeps the rules, and what it says gives the bytes', ({ request }) => {
    const { plan } = makePlan([{ name: undefined, request }], settingsOf({}));
    const machine = new Machine(asStructuredText(scl.write(plan).files[0]?.text ?? ''));
    const [planned] = plan.requests;
    const frame = machine.array({ rtu: 256, ascii: 513, tcp: 260 }[transport]);
    const given = (planned?.arguments ?? []).map(({ parameter, value }) =>
      parameter.type === 'bool' ? (Array.isArray(value) ? value.map(Boolean) : value === 1) : value,
    );
    const build =
      machine.units.find((name) => /^FC_Build/.test(name)) ?? machine.units.find((name) => /Frame$/.test(name));
    const length = machine.call(build ?? '', ...given, frame);
    expect(frame.slice(0, Number(length))).toEqual([...encodeFrame(request)]);
    const [good] = repliesTo(request);
    const check = machine.units.find((name) => name.startsWith('FC_Check'));
    if (check === undefined || good === undefined) return;
    const reply = [...good.bytes, ...frame.map(() => 0)].slice(0, frame.length);
    const list = planned?.list?.size === undefined ? [] : [machine.array(planned.list.size)];
    expect(machine.call(check, good.bytes.length, frame, reply, ...list)).toBe(0);
  });
});

test('a sequence keeps the rules', () => {
  if (!motor) throw new Error('no sequence');
  for (const options of [{}, { comments: false }, { echo: true }])
    expect(() => new Machine(asStructuredText(sclOf({ sequence: motor }, options)))).not.toThrow();
});

test('tables stand in a data block', () => {
  const [first] = programCases('rtu', 0);
  if (!first) throw new Error('no case');
  const text = sclOf({ request: first.request }, { crc: 'table' });
  expect(text).toContain('crcTable : Array[0..255] of Word;');
  expect(text).toContain('crcTable[1] := WORD#16#C0C1;');
  expect(text).toContain('"ModbusTables".crcTable[');
});

describe('the rules refuse', () => {
  const good = sclOf({
    request: programCases('rtu', 0).find(({ name }) => name === 'write registers')?.request as never,
  });

  test.each<[what: string, from: string | RegExp, to: string]>([
    ['a local name without #', '#remainder := WORD#16#FFFF;', 'remainder := WORD#16#FFFF;'],
    ['a local name without # in an expression', '#remainder XOR', 'remainder XOR'],
    ['a block without quotes', '"FC_Crc"(', 'FC_Crc('],
    ['a block that is declared without quotes', 'FUNCTION "FC_Crc"', 'FUNCTION FC_Crc'],
    ['>>', 'SHR(IN := #remainder, N := 1)', '#remainder >> 1'],
    ['a literal without a type', 'WORD#16#FFFF', '16#FFFF'],
    ['variables that a function would keep', 'VAR_TEMP', 'VAR'],
    ['an array with first values', 'registers : Array[0..1] of Word;', 'registers : Array[0..1] of Word := [1, 2];'],
    ['a type that there is not', 'remainder : Word;', 'remainder : UWord;'],
    ['a missing BEGIN', 'BEGIN', ''],
    ['a missing end', /END_FUNCTION_BLOCK\n$/, ''],
  ])('%s', (_, from, to) => {
    expect(() => asStructuredText(good)).not.toThrow();
    expect(good.replace(from, to)).not.toBe(good);
    expect(() => asStructuredText(good.replace(from, to))).toThrow(SclFault);
  });

  test('what is converted by itself', () => {
    const text = good.replace('BYTE_TO_WORD(#bytes[#index])', '#bytes[#index]');
    expect(text).not.toBe(good);
    expect(() => new Machine(asStructuredText(text))).toThrow('WORD XOR BYTE');
  });
});
