import { beforeAll, describe, expect, test } from 'vitest';
import { CodeRunner } from '../codegen/run-code.ts';
import { hex } from '../modbus/frames.ts';
import type * as Layers from './layers.ts';
import { exampleOfContributing, layersWith } from './with-function.ts';

/** An invented function that reads, as CONTRIBUTING's example is one that writes. */
const READS = `
import { layout } from '../field.ts';
import { address, bytesOfRegisters, count, even, fitsRequest, lengthOf, quantity } from '../fields/number.ts';
import { registers } from '../fields/registers.ts';
import { defineFunction } from '../function-code.ts';

export const readRecipe = defineFunction({
  code: 0x64,
  name: 'Read Recipe',
  section: 'AP 5',
  group: 'registers',
  table: 'holding-register',
  items: 'many',
  access: 'reads',
  probe: { recipeAddress: 0, quantity: 1 },
  request: layout([address('recipeAddress'), quantity('quantity', { from: 'recipeAddress', least: 1, most: 60 })]),
  response: layout([
    count('byteCount', {
      least: 2,
      most: 120,
      derive: lengthOf('registers', bytesOfRegisters),
      rules: [even],
      replyRules: [fitsRequest('quantity', bytesOfRegisters)],
    }),
    registers('registers', ({ count }) => count),
  ]),
});
`;

const UNIT = 17;

const variants = [
  {
    name: 'readRecipe',
    source: async () => READS,
    access: 'reads',
    // Unit 17, function 64, recipe 5, 2 registers.
    request: '11 64 00 05 00 02',
    texts: { recipeAddress: '5', quantity: '2' },
    paths: ['recipeAddress', 'quantity'],
    kind: 'layout',
    // Byte count 4, and as many zeros as were asked for.
    expected: '11 64 04 00 00 00 00',
  },
  {
    name: 'writeRecipe',
    source: exampleOfContributing,
    access: 'writes',
    // Unit 17, function 64, recipe 5, 2 registers of 4 bytes: 1234 and 0001.
    request: '11 64 00 05 00 02 04 12 34 00 01',
    texts: { recipeAddress: '5', registers: '0x1234 1' },
    paths: ['recipeAddress', 'quantity', 'byteCount', 'registers'],
    kind: 'exact',
    // It repeats recipe and quantity.
    expected: '11 64 00 05 00 02',
  },
] as const;

describe.each(variants)('function 64, added as $name', ({ name, source, access, texts, paths, kind, ...bytes }) => {
  let layers: typeof Layers;
  const changes = access === 'writes';

  beforeAll(async () => {
    layers = await layersWith(name, await source());
  });

  /** The frame with its CRC, low byte first. */
  const framed = (text: string): Uint8Array => {
    const body = hex(text);
    const crc = layers.modbus.crc16(body);
    return Uint8Array.of(...body, crc & 0xff, crc >> 8);
  };
  const asked = () => layers.modbus.decodeFrame(framed(bytes.request), { transport: 'rtu', direction: 'request' });

  test('the decoder reads it, and frames are found in streams', () => {
    const { outcome, problems, description } = asked();
    expect([outcome.kind, problems, description?.code]).toEqual(['whole', [], 0x64]);
    expect(layers.modbus.codeRange(0x64)).toBe('public');
    const stream = Uint8Array.of(0xff, 0xff, ...framed(bytes.request), 0xff);
    expect(layers.modbus.framesAt(stream, 2, stream.length, 'rtu')).toMatchObject([
      { direction: 'request', legal: true, to: stream.length - 1 },
    ]);
    const [best] = layers.diagnosis.identify(framed(bytes.request));
    expect(best).toMatchObject({ transport: 'rtu', direction: 'request', reading: { functionCode: 0x64 } });
  });

  test('the guard asks about it only if it writes', () => {
    const { mayChange, permissionFor } = layers.bus;
    expect(mayChange(asked())).toBe(changes);
    expect(permissionFor(asked(), { readOnly: true, writable: new Set() })).toEqual(
      changes ? { kind: 'refused', why: 'read-only' } : { kind: 'free' },
    );
    expect(permissionFor(asked(), { readOnly: false, writable: new Set() })).toEqual(
      changes ? { kind: 'ask', why: 'first-write', once: true } : { kind: 'free' },
    );
  });

  test('the scan of functions probes it only if it reads', () => {
    const requests = layers.bus.requestsOf({
      kind: 'scan',
      what: 'functions',
      transport: 'rtu',
      timeout: 50,
      unit: UNIT,
    });
    const sent = requests.filter((request) => request[1] === 0x64);
    // Recipe 0, one register.
    expect(sent).toEqual(changes ? [] : [framed('11 64 00 00 00 01')]);
  });

  test('a sequence sends it, and it is asked about first if it writes', () => {
    const send = (bytes: string) => ({ kind: 'send', fields: { bytes, onFailure: 'stop' } }) as const;
    const others = ['11 03 00 00 00 01 86 9A', Buffer.from(framed(bytes.request)).toString('hex')];
    const texts = { name: 'a', about: '', transport: 'rtu', steps: others.map(send), finally: [] } as const;
    const reading = layers.sequences.readSequence(texts);
    if (reading.kind !== 'sequence') throw new Error(`not a sequence: ${JSON.stringify(reading)}`);
    const requests = layers.bus.requestsOf({ kind: 'sequence', sequence: reading.sequence });
    expect(requests.map((request) => request[1])).toEqual(changes ? [0x64, 0x03] : [0x03, 0x64]);
  });

  test('polls, conditions and devices go on reading and writing with the usual functions', () => {
    const { readerOf, writerOf, twinOf, mostOf, writesAt, describeFunction, functionsOf } = layers.modbus;
    expect(readerOf('holding-register').code).toBe(0x03);
    expect(writerOf('holding-register', 'many').code).toBe(0x10);
    expect(functionsOf('holding-register').map(({ code }) => code)).toContain(0x64);
    const description = describeFunction(0x64, 'request');
    expect(mostOf(description)).toBe(60);
    expect(twinOf(0x64)).toBeUndefined();
    expect(writesAt(description, 'recipeAddress')).toBe(changes);
    expect(layers.devices.mostRead).toEqual({ bits: 2000, registers: 125 });
  });

  test('virtual devices refuse it: they do not know how to carry it out', () => {
    const server = new layers.bus.VirtualServer({ name: 'device', unit: UNIT });
    const heard = server.hear(framed(bytes.request), 'rtu');
    expect(heard).toEqual({ does: 'answer', reply: framed('11 E4 01'), exceptionCode: 1 });
  });

  test('its command is copied as raw bytes', () => {
    const pdu = hex(bytes.request);
    const tcp = Uint8Array.of(0, 1, 0, 0, 0, pdu.length, ...pdu);
    const reading = layers.modbus.decodeFrame(tcp, { transport: 'tcp', direction: 'request' });
    expect(reading.problems).toEqual([]);
    expect(layers.bus.mbpollCommand(reading, 'plc')).toBeUndefined();
    expect(layers.bus.ncCommand(tcp, 'plc', 502)).toContain('\\021\\144\\000\\005\\000\\002');
  });

  test('the form offers it with its fields, and knows the reply', () => {
    const { evaluate, expectReply, firstDraft } = layers.workbench;
    const offered = layers.modbus.functionCodes.filter(({ group }) => group === 'registers');
    expect(offered.map(({ code }): number => code)).toContain(0x64);
    const draft = { ...firstDraft, texts: { unitId: String(UNIT), functionCode: '0x64', ...texts } };
    const evaluation = evaluate(draft);
    expect(evaluation.controls.map(({ path }) => path)).toEqual(paths);
    expect(evaluation.frame?.bytes).toEqual(framed(bytes.request));
    const reply = expectReply(draft, asked(), framed(bytes.request));
    expect(reply).toMatchObject({ kind, evaluation: { frame: { bytes: framed(bytes.expected) } } });
  });

  test('programs build it, and check its reply', () => {
    const { makePlan, settingsOf } = layers;
    const { unitId, functionCode, fields } = asked();
    const input = { transport: 'rtu', direction: 'request', unitId, functionCode, fields } as const;
    const { plan, notes } = makePlan([{ name: undefined, request: input }], settingsOf());
    const [request] = plan.requests;
    if (request?.build === undefined || request.check === undefined) throw new Error('not built, or not checked');
    const runner = new CodeRunner(plan.code);
    const given = request.arguments.map(({ value }) => (typeof value === 'number' ? value : [...value]));
    expect(notes).toEqual([]);
    expect(runner.run(request.build, ...given)).toEqual([...framed(bytes.request)]);
    const check = (reply: Uint8Array) => {
      const list = request.list === undefined ? [] : [new Array<number>(request.list.size ?? 0).fill(1)];
      return [runner.run(request.check ?? '', [...framed(bytes.request)], [...reply], reply.length, ...list), ...list];
    };
    expect(check(framed(bytes.expected))).toEqual(changes ? [0] : [0, [0, 0]]);
    expect(check(framed('11 E4 02'))[0]).toBe(2);
    // One register fewer, and another recipe.
    expect(check(framed(changes ? '11 64 00 06 00 02' : '11 64 02 00 00'))[0]).toBe(changes ? -6 : -5);
  });
});
