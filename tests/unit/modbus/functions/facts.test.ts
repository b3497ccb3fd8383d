import { describe, expect, test } from 'vitest';
import {
  accessOf,
  counterpart,
  decodeFrame,
  encodeFrame,
  type FunctionCode,
  fieldsOf,
  functionCodes,
  mostOf,
  rawFunction,
  readerOf,
  toHex,
  twinOf,
  writerOf,
  writesAt,
} from '../../../../src/modbus/index.ts';

const all: readonly FunctionCode[] = functionCodes;
const requestFields = (description: FunctionCode) =>
  [...fieldsOf(description, 'request', {})].map(({ field }) => field);

test('what each function does to a device, and with how many elements (AP 6)', () => {
  expect(all.map(({ code, access, items }) => [code, typeof access === 'string' ? access : access.by, items])).toEqual([
    [0x01, 'reads', 'many'],
    [0x02, 'reads', 'many'],
    [0x03, 'reads', 'many'],
    [0x04, 'reads', 'many'],
    [0x05, 'writes', 'one'],
    [0x06, 'writes', 'one'],
    [0x07, 'reads', undefined],
    [0x08, 'subFunction', undefined],
    [0x0b, 'reads', undefined],
    [0x0c, 'reads', undefined],
    [0x0f, 'writes', 'many'],
    [0x10, 'writes', 'many'],
    [0x11, 'reads', undefined],
    [0x14, 'reads', 'other'],
    [0x15, 'writes', 'other'],
    [0x16, 'writes', 'other'],
    [0x17, 'reads-and-writes', 'many'],
    [0x18, 'reads', 'other'],
    [0x2b, 'meiType', undefined],
  ]);
});

test('every value of the field that decides: 08 answers or clears (AP 6.8.1), 2B reads identification or anything (AP 6.19)', () => {
  const reading = (functionCode: number, values: readonly number[]) =>
    values.filter((value) => {
      const bytes = functionCode === 0x08 ? [0x08, 0x00, value, 0x00, 0x00] : [0x2b, value, 0x01, 0x00];
      const asked = decodeFrame(Uint8Array.from(bytes), { transport: 'pdu', direction: 'request' });
      return accessOf(asked) === 'reads';
    });
  const bytes = Array.from({ length: 256 }, (_, value) => value);
  expect(reading(0x08, bytes)).toEqual([0x00, 0x02, 0x0b, 0x0c, 0x0d, 0x0e, 0x0f, 0x10, 0x11, 0x12]);
  expect(reading(0x2b, bytes)).toEqual([0x0e]);
});

test('a request that is cut off before the field that decides may change a device', () => {
  for (const bytes of [[], [0x08], [0x08, 0x00], [0x2b]]) {
    const asked = decodeFrame(Uint8Array.from(bytes), { transport: 'pdu', direction: 'request' });
    expect(accessOf(asked), toHex(Uint8Array.from(bytes))).toBe('writes');
  }
});

test('so may every request that nobody has described', () => {
  const described = new Set<number>(functionCodes.map(({ code }) => code));
  for (let code = 0; code < 256; code++) {
    if (described.has(code)) continue;
    const asked = decodeFrame(Uint8Array.of(code, 0x00), { transport: 'pdu', direction: 'request' });
    expect(accessOf(asked), String(code)).toBe('writes');
  }
});

describe('a function that reads has a probe, and no other has', () => {
  test.each(all.map((description) => [description.name, description] as const))('%s', (_, description) => {
    const { code, access, probe } = description;
    expect(probe !== undefined).toBe(access !== 'writes' && access !== 'reads-and-writes');
    if (probe === undefined) return;
    const bytes = encodeFrame({ transport: 'pdu', direction: 'request', functionCode: code, fields: probe });
    const { outcome, problems, ...reading } = decodeFrame(bytes, { transport: 'pdu', direction: 'request' });
    expect([outcome.kind, problems]).toEqual(['whole', []]);
    expect(accessOf(reading)).toBe('reads');
  });
});

describe('the number of items is that of the fields', () => {
  test.each(all.map((description) => [description.name, description] as const))('%s', (_, description) => {
    const kinds = requestFields(description).map(({ kind }) => kind);
    const { table, items } = description;
    expect(items === undefined).toBe(table === undefined);
    if (items === 'one') expect(kinds).toEqual(['address', expect.stringMatching(/^(number|flag)$/)]);
    if (items === 'many') expect(kinds.slice(0, 2)).toEqual(['address', 'quantity']);
    else expect(kinds).not.toContain('quantity');
  });
});

test('which functions read and write the tables, and how many elements at most (AP 6.1 to 6.12)', () => {
  const tables = ['coil', 'discrete-input', 'input-register', 'holding-register'] as const;
  expect(tables.map((table) => [readerOf(table).code, mostOf(readerOf(table))])).toEqual([
    [0x01, 2000],
    [0x02, 2000],
    [0x04, 125],
    [0x03, 125],
  ]);
  expect([writerOf('coil', 'one').code, writerOf('holding-register', 'one').code]).toEqual([0x05, 0x06]);
  const many = [writerOf('coil', 'many'), writerOf('holding-register', 'many')];
  expect(many.map((writer) => [writer.code, mostOf(writer)])).toEqual([
    [0x0f, 1968],
    [0x10, 123],
  ]);
  expect(mostOf(writerOf('coil', 'one'))).toBe(1);
});

test('the counterpart in the other table of bits or of registers', () => {
  const twins = all.flatMap(({ code }) => {
    const twin = twinOf(code);
    return twin === undefined ? [] : [[code, twin.code]];
  });
  expect(twins).toEqual([
    [0x01, 0x02],
    [0x02, 0x01],
    [0x03, 0x04],
    [0x04, 0x03],
  ]);
  expect(counterpart(0x03, 'coil')?.code).toBe(0x01);
});

test('17 writes at its second address only (AP 6.17)', () => {
  const description = functionCodes.find(({ code }) => code === 0x17) as FunctionCode;
  expect(writesAt(description, 'readStartAddress')).toBe(false);
  expect(writesAt(description, 'writeStartAddress')).toBe(true);
});

test('the types ask what a function does, how it is probed, and how many elements of its table it is about', () => {
  const { code, name, section, group, request, response } = rawFunction;
  const described = { code, name, section, group, request, response } as const;
  const refused: readonly FunctionCode[] = [
    // @ts-expect-error: what it does to a device is not said
    described,
    // @ts-expect-error: how it is probed is not said
    { ...described, access: 'reads' },
    // @ts-expect-error: what writes is not probed
    { ...described, access: 'writes', probe: {} },
    // @ts-expect-error: how many elements of the table is not said
    { ...described, access: 'writes', table: 'coil' },
  ];
  expect(refused).toHaveLength(4);
});
