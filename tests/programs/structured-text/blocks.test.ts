import { describe, expect, test } from 'vitest';
import type { ProgramOptions } from '../../../src/codegen/options.ts';
import { writeProgram } from '../../../src/codegen/program.ts';
import { encodeFrame, type FrameInput } from '../../../src/modbus/index.ts';
import type { Sequence } from '../../../src/sequences/index.ts';
import { sequences } from '../cases.ts';
import { carryOut, type Line } from './line.ts';
import { Machine } from './machine.ts';

const TARGET = 'structured-text';
const machineOf = (what: Parameters<typeof writeProgram>[1], options?: ProgramOptions) =>
  new Machine(writeProgram(TARGET, what, options).files[0]?.text ?? '');
const block = (machine: Machine) => machine.instance(machine.units.find((name) => name.startsWith('FB_')) ?? '');
const hex = (text: string): number[] => text.split(' ').map((pair) => Number.parseInt(pair, 16));
const spaced = (bytes: readonly number[]): string =>
  bytes.map((one) => one.toString(16).toUpperCase().padStart(2, '0')).join(' ');

const ask = (functionCode: number, fields: FrameInput['fields'], more: Partial<FrameInput> = {}): FrameInput => ({
  transport: 'rtu',
  direction: 'request',
  unitId: 6,
  functionCode,
  fields,
  ...more,
});
/** Three registers of unit 6, and their reply. */
const reading = ask(3, { startAddress: 1, quantity: 3 });
const answer = [...encodeFrame({ ...reading, direction: 'response', fields: { registers: [1, 0x8000, 0xffff] } })];
const refusal = [
  ...encodeFrame({ ...reading, direction: 'response', functionCode: 0x83, fields: { exceptionCode: 4 } }),
];

describe('the function block of a request', () => {
  const exchange = (line: Partial<Line>, options?: ProgramOptions) => {
    const machine = machineOf({ request: reading }, options);
    const one = block(machine);
    const carried = carryOut(machine, one, { reply: () => answer, ...line });
    return { machine, one, carried, result: one.get('Result'), done: one.get('Done'), error: one.get('Error') };
  };

  test('sends, waits for the whole reply, and gives its values', () => {
    const { one, carried, done, error, result } = exchange({});
    expect(carried.sent.map(({ bytes }) => bytes)).toEqual([[...encodeFrame(reading)]]);
    expect({ done, error, result }).toEqual({ done: true, error: false, result: 0 });
    expect(one.get('Registers')).toEqual([1, 0x8000, 0xffff]);
    // Eleven bytes at four a cycle.
    expect(carried.ended).toBe(30);
  });

  test.each([1, 3, 11])('takes the reply in pieces of %i bytes', (aCycle) => {
    expect(exchange({ aCycle })).toMatchObject({ done: true, result: 0 });
  });

  test('throws away what stood there before', () => {
    expect(exchange({ before: hex('06 03 06 00') })).toMatchObject({ done: true, result: 0 });
  });

  test('says which exception came, before its time is over', () => {
    const { one, carried, done, error, result } = exchange({ reply: () => refusal });
    expect({ done, error, result }).toEqual({ done: false, error: true, result: 4 });
    expect(one.get('Message')).toBe('SERVER DEVICE FAILURE');
    expect(carried.ended).toBeLessThan(100);
  });

  test('ends when its time is over, with what is wrong', () => {
    const silent = exchange({ reply: () => undefined }, { timeout: 250 });
    expect(silent).toMatchObject({ done: false, error: true, result: -8 });
    // 250 ms from the end of eight characters, and the cycles around them.
    expect(silent.carried.ended).toBeGreaterThanOrEqual(250);
    expect(silent.carried.ended).toBeLessThanOrEqual(290);
    expect(exchange({ reply: () => answer.slice(0, -1) })).toMatchObject({ error: true, result: -1 });
  });

  test('skips its own bytes where the adapter gives them back', () => {
    expect(exchange({ echo: true }, { echo: true })).toMatchObject({ done: true, result: 0 });
    expect(exchange({ echo: true, reply: () => undefined }, { echo: true })).toMatchObject({ result: -8 });
  });

  test('waits for silence where no byte says where the reply ends', () => {
    const request = ask(0x41, { data: '01' });
    const machine = machineOf({ request });
    const one = block(machine);
    const reply = [...encodeFrame({ ...request, direction: 'response', fields: { data: '0203040506' } })];
    const { ended } = carryOut(machine, one, { reply: () => reply, aCycle: 3 });
    expect(one.get('Done')).toBe(true);
    expect(ended).toBeGreaterThanOrEqual(50);
  });

  test('gives devices time after a broadcast, and waits for no reply', () => {
    const machine = machineOf({ request: ask(6, { address: 1, value: 3 }, { unitId: 0 }) });
    const one = block(machine);
    const { ended, sent } = carryOut(machine, one, { reply: () => undefined });
    expect(sent).toHaveLength(1);
    expect(one.get('Done')).toBe(true);
    expect(ended).toBeGreaterThanOrEqual(100);
  });

  test('runs again at the next rising edge only', () => {
    const { machine, one } = exchange({});
    expect(carryOut(machine, one, { reply: () => answer }).sent).toEqual([]);
    carryOut(machine, one, { reply: () => answer }, () => ({ Execute: false }));
    expect(carryOut(machine, one, { reply: () => answer }).sent).toHaveLength(1);
  });

  test('takes other values than those of the page', () => {
    const machine = machineOf({ request: ask(16, { startAddress: 1, registers: [10, 0x102] }) });
    const one = block(machine);
    const { sent } = carryOut(machine, one, { reply: () => undefined }, () => ({ Registers: [1, 2], StartAddress: 5 }));
    const other = ask(16, { startAddress: 5, registers: [1, 2] });
    expect(sent.map(({ bytes }) => bytes)).toEqual([[...encodeFrame(other)]]);
  });

  test.each(['ascii', 'tcp'] as const)('speaks %s', (transport) => {
    const request = { ...reading, transport, ...(transport === 'tcp' && { transactionId: 9 }) };
    const machine = machineOf({ request });
    const one = block(machine);
    const reply = [...encodeFrame({ ...request, direction: 'response', fields: { registers: [1, 2, 3] } })];
    const { sent } = carryOut(machine, one, { reply: () => reply });
    expect(sent.map(({ bytes }) => bytes)).toEqual([[...encodeFrame(request)]]);
    expect([one.get('Done'), one.get('Registers')]).toEqual([true, [1, 2, 3]]);
  });

  test('says how many values a reply has that may have fewer', () => {
    const request = ask(0x18, { fifoPointerAddress: 0x4de });
    const machine = machineOf({ request });
    const one = block(machine);
    const reply = [...encodeFrame({ ...request, direction: 'response', fields: { fifoValues: [0x1b8, 0x1284] } })];
    carryOut(machine, one, { reply: () => reply });
    expect([one.get('Done'), one.get('ItemCount')]).toEqual([true, 2]);
  });

  test('stands once for each of several frames, with one CRC', () => {
    const machine = machineOf({
      frames: [
        { name: 'Set speed', request: ask(6, { address: 683, value: 4096 }) },
        { name: 'Start', request: ask(6, { address: 682, value: 1 }) },
      ],
    });
    expect(machine.units.filter((name) => name.startsWith('FB_'))).toEqual(['FB_SetSpeed', 'FB_Start']);
    expect(machine.units.filter((name) => /crc/i.test(name))).toHaveLength(1);
  });
});

/** A drive that answers each write with its echo, and each reading with the next of these values. */
const drive = (values: readonly number[], silentAt = -1): Line['reply'] => {
  let asked = 0;
  let read = 0;
  return (bytes) => {
    if (asked++ === silentAt) return undefined;
    if (bytes[1] !== 3) return bytes;
    const value = values[Math.min(read++, values.length - 1)] ?? 0;
    return [...encodeFrame(ask(3, { registers: [value] }, { direction: 'response', unitId: bytes[0] ?? 0 }))];
  };
};
const sent = (functionCode: number, fields: FrameInput['fields']) =>
  spaced([...encodeFrame(ask(functionCode, fields))]);
const SPEED = sent(6, { address: 683, value: 4096 });
const RUN = sent(6, { address: 682, value: 1 });
const STOP = sent(6, { address: 682, value: 0 });
const READ = sent(3, { startAddress: 681, quantity: 1 });

describe('the function block of a sequence', () => {
  const run = (sequence: Sequence, reply: Line['reply'], given?: (now: number) => object, options?: ProgramOptions) => {
    const machine = machineOf({ sequence }, options);
    const one = block(machine);
    const carried = carryOut(machine, one, { reply }, given);
    const frames = carried.sent.map(({ bytes }) => spaced(bytes));
    return {
      ...carried,
      frames,
      result: one.get('Result'),
      done: one.get('Done'),
      step: one.get('FailedStep'),
      message: one.get('Message'),
    };
  };
  const [motor] = sequences;
  if (!motor) throw new Error('no sequence');

  test('starts the motor, waits for its speed, and stops it', () => {
    const { frames, done, result, message, step, sent: all, ended } = run(motor, drive([0, 3999, 4000]));
    expect(frames).toEqual([SPEED, RUN, READ, READ, READ, STOP]);
    expect([done, result, message, step]).toEqual([true, 0, '', 0]);
    // 100 ms between the readings, and ten seconds of running.
    const [, , first = 0, second = 0, third = 0, stop = 0] = all.map(({ at }) => at);
    expect(second - first).toBeGreaterThanOrEqual(100);
    expect(stop - third).toBeGreaterThanOrEqual(10_000);
    expect(stop - third).toBeLessThan(10_300);
    expect(ended).toBeGreaterThan(stop);
  });

  test('stops the motor if a step fails', () => {
    const { frames, done, result, message, step } = run(motor, drive([4000], 1), undefined, { timeout: 200 });
    expect(frames).toEqual([SPEED, RUN, STOP]);
    expect([done, result, message]).toEqual([false, -8, 'no reply']);
    expect(step).toBe(3);
  });

  test('stops the motor if its speed does not come in time', () => {
    const { frames, done, result, message, ended } = run(motor, drive([1000]));
    expect(frames.at(-1)).toBe(STOP);
    expect(frames.filter((one) => one === READ).length).toBeGreaterThan(20);
    expect([done, result, message]).toEqual([false, -100, 'a condition did not hold in time']);
    expect(ended).toBeGreaterThan(5000);
    expect(ended).toBeLessThan(5600);
  });

  test('stops the motor when somebody asks for it', () => {
    const { frames, ended } = run(motor, drive([4000]), (now) => ({ Stop: now > 2000 }));
    expect(frames).toEqual([SPEED, RUN, READ, STOP]);
    expect(ended).toBeLessThan(2300);
  });

  test('reads on after a reading that fails', () => {
    const { frames, done } = run(motor, drive([0, 4000], 3), undefined, { timeout: 200 });
    expect(frames).toEqual([SPEED, RUN, READ, READ, READ, STOP]);
    expect(done).toBe(true);
  });

  const write = (value: number, onFailure: 'stop' | 'go-on' = 'stop', unitId = 6) =>
    ({ kind: 'send', bytes: encodeFrame(ask(6, { address: 1, value }, { unitId })), onFailure }) as const;

  test('repeats steps, also within each other, and goes on after a failure that ends nothing', () => {
    const sequence: Sequence = {
      transport: 'rtu',
      steps: [
        { kind: 'repeat', times: 2, steps: [write(1), { kind: 'repeat', times: 3, steps: [write(2, 'go-on')] }] },
        { kind: 'repeat', times: 0, steps: [write(9)] },
        write(3, 'stop', 0),
      ],
      finally: [write(4), write(5)],
    };
    const values = (frames: readonly string[]) => frames.map((one) => Number(one.split(' ')[5]));
    expect(values(run(sequence, drive([])).frames)).toEqual([1, 2, 2, 2, 1, 2, 2, 2, 3, 4, 5]);
    const failed = run(sequence, drive([], 2), undefined, { timeout: 100 });
    expect(values(failed.frames)).toEqual([1, 2, 2, 2, 1, 2, 2, 2, 3, 4, 5]);
    expect([failed.done, failed.result]).toEqual([false, -8]);
    // A failure in the finally list ends nothing.
    expect(values(run(sequence, drive([], 9), undefined, { timeout: 100 }).frames)).toHaveLength(11);
  });

  test('waits, and sends nothing but broadcasts, without a line that answers', () => {
    const sequence: Sequence = {
      transport: 'rtu',
      steps: [write(1, 'stop', 0), { kind: 'wait', duration: 500 }, write(2, 'stop', 0)],
      finally: [],
    };
    const { sent: all, done } = run(sequence, () => undefined);
    expect(all).toHaveLength(2);
    expect((all[1]?.at ?? 0) - (all[0]?.at ?? 0)).toBeGreaterThanOrEqual(600);
    expect(done).toBe(true);
  });

  test('sends lists, and frames that are broken', () => {
    const list = encodeFrame(ask(16, { startAddress: 1, registers: [10, 0x102] }));
    const broken = Uint8Array.of(6, 6, 2);
    const sequence: Sequence = {
      transport: 'rtu',
      steps: [
        { kind: 'send', bytes: list, onFailure: 'go-on' },
        { kind: 'send', bytes: broken, onFailure: 'go-on' },
      ],
      finally: [],
    };
    const { frames } = run(sequence, drive([]), undefined, { timeout: 100 });
    expect(frames).toEqual([spaced([...list]), spaced([...broken])]);
  });
});
