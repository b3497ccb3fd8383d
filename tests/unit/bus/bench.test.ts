import { describe, expect, test } from 'vitest';
import {
  defaultSettings,
  Session,
  type SessionCommand,
  type SessionNews,
  sourceSetups,
  type VirtualNews,
} from '../../../src/bus/index.ts';
import { type Profile, plainRegister } from '../../../src/devices/index.ts';
import { hex } from '../modbus/frames.ts';
import { ScriptedLink } from './scripted-link.ts';
import { VirtualClock } from './virtual-clock.ts';

const READ_33 = hex('21 03 03 E7 00 04 F3 1A');
const READ_33_REPLY = hex('21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18');

async function open(...commands: readonly SessionCommand[]) {
  const clock = new VirtualClock();
  const news: SessionNews[] = [];
  const link = new ScriptedLink(clock);
  const session = new Session({ clock, tell: (one) => news.push(one), portLink: () => Promise.resolve(link) });
  const take = async (...all: readonly SessionCommand[]) => {
    for (const command of all) {
      void session.take(command);
      await clock.advance(500);
    }
  };
  await take(
    { kind: 'virtual', order: { kind: 'devices', devices: sourceSetups() } },
    { kind: 'open-virtual', settings: defaultSettings, pace: 'fast' },
    ...commands,
  );
  const virtual = <K extends VirtualNews['kind']>(kind: K) =>
    news.flatMap((one) =>
      one.kind === 'virtual' && one.news.kind === kind ? [one.news as Extract<VirtualNews, { kind: K }>] : [],
    );
  return { clock, news, link, take, virtual };
}

const watch = (id: number, from: number): SessionCommand => ({
  kind: 'virtual',
  order: { kind: 'watch', id, table: 'holding-register', from, count: 4 },
});
const send = (request: Uint8Array): SessionCommand => ({ kind: 'send', id: 1, request, confirmed: true });

describe('the virtual bus of a session', () => {
  test('answers', async () => {
    const { news } = await open(send(READ_33));
    expect(news).toContainEqual(
      expect.objectContaining({ kind: 'result', result: expect.objectContaining({ reply: READ_33_REPLY }) }),
    );
  });

  test('tells who heard what, and why the others are silent, while somebody watches', async () => {
    const { take, virtual } = await open(send(READ_33));
    expect(virtual('heard')).toEqual([]);
    await take(watch(5, 999), send(READ_33));
    const [frame] = virtual('heard').flatMap(({ frames }) => frames);
    expect(frame).toMatchObject({ bytes: READ_33 });
    expect(frame?.by.map(({ unit, does, why, reply }) => [unit, does, why, reply])).toEqual([
      [1, 'nothing', 'other-unit', undefined],
      [6, 'nothing', 'other-unit', undefined],
      [9, 'nothing', 'other-unit', undefined],
      [17, 'nothing', 'other-unit', undefined],
      [33, 'answer', undefined, READ_33_REPLY],
    ]);
  });

  test('tells what stands in a device when it changes, and not again while it does not', async () => {
    const { take, virtual } = await open(watch(5, 998));
    expect(virtual('watched').map(({ cells }) => cells.values)).toEqual([[0, 12345, 54321, 6666]]);
    await take({
      kind: 'virtual',
      order: { kind: 'write', id: 5, table: 'holding-register', from: 998, values: [7, 8] },
    });
    expect(virtual('watched').map(({ cells }) => cells.values)).toEqual([
      [0, 12345, 54321, 6666],
      [7, 8, 54321, 6666],
    ]);
    await take(send(hex('21 03 03 E6 00 02 22 D8')));
    await take({ kind: 'virtual', order: { kind: 'unwatch' } });
    const told = virtual('watched').length;
    await take({ kind: 'virtual', order: { kind: 'write', id: 5, table: 'holding-register', from: 998, values: [9] } });
    expect(virtual('watched')).toHaveLength(told);
  });

  test('says of a device which addresses it has', async () => {
    const { virtual } = await open(watch(2, 683));
    expect(virtual('watched')[0]?.cells.values).toEqual([0, undefined, 0, undefined]);
  });

  test('hands out what stands in the devices a while after it was changed, and takes it back', async () => {
    const { clock, take, virtual } = await open(
      { kind: 'set-read-only', readOnly: false },
      send(hex('06 06 02 AB 10 00 F5 E5')),
    );
    await clock.advance(2000);
    const kept = virtual('kept');
    expect(kept).toHaveLength(1);
    const drive = kept[0]?.devices.find(({ id }) => id === 2);
    expect(drive?.values).toEqual([{ table: 'holding-register', from: 683, values: [0x1000] }]);
    // As another session would begin.
    const devices = [{ id: 20, model: 'weg-drive', unit: 6, on: true, values: drive?.values } as const];
    await take({ kind: 'virtual', order: { kind: 'devices', devices } }, watch(20, 683));
    expect(virtual('watched').at(-1)?.cells.values[0]).toBe(0x1000);
  });

  test('a device without power hears nothing, and one with another unit answers there', async () => {
    const { take, news } = await open();
    const devices = sourceSetups().map((setup) => ({
      ...setup,
      on: setup.unit !== 1,
      unit: setup.unit === 33 ? 1 : setup.unit,
    }));
    await take({ kind: 'virtual', order: { kind: 'devices', devices } }, send(hex('01 03 03 E7 00 01 34 79')));
    expect(news).toContainEqual(
      expect.objectContaining({
        kind: 'result',
        result: expect.objectContaining({ reply: hex('01 03 02 30 39 6C 56') }),
      }),
    );
  });

  test('a device of a profile has the registers that are in it', async () => {
    const profile = {
      id: 'meter',
      name: 'Meter',
      source: '',
      convention: 'zero-based',
      traits: [],
      notes: [],
      registers: [{ ...plainRegister, name: 'Power', table: 'holding-register', address: 0x10, type: 'u32' }],
    } as const satisfies Profile;
    const { take, virtual } = await open();
    const devices = [{ id: 9, model: 'plain', profile, unit: 2, on: true } as const];
    await take({ kind: 'virtual', order: { kind: 'devices', devices } }, watch(9, 0x0f));
    expect(virtual('watched')[0]?.cells.values).toEqual([undefined, 0, 0, undefined]);
  });

  test('tells what is left of the faults', async () => {
    const fault = { fault: { kind: 'exception', exceptionCode: 6 }, unit: 33, times: 2 } as const;
    const { virtual } = await open({ kind: 'virtual', order: { kind: 'faults', faults: [fault] } }, send(READ_33));
    expect(virtual('faults')).toEqual([{ kind: 'faults', faults: [{ ...fault, times: 1 }] }]);
  });
});

describe('virtual devices on the port of a session', () => {
  const port: SessionCommand = { kind: 'open-port', port: {}, settings: defaultSettings };

  test('answer there, and the page sends nothing until they stop', async () => {
    const { take, news, link } = await open(port, { kind: 'serve', on: true });
    expect(news).toContainEqual({ kind: 'serving', on: true });
    link.receive(READ_33);
    await take(send(READ_33));
    expect(link.written.map(({ bytes }) => bytes)).toEqual([READ_33_REPLY]);
    expect(news).toContainEqual({ kind: 'refused', id: 1, why: 'serving' });
    expect(news.flatMap((one) => (one.kind === 'lines' ? one.lines.map(({ kind }) => kind) : []))).toEqual([
      'request',
      'reply',
    ]);
    await take({ kind: 'serve', on: false }, send(READ_33));
    expect(news).toContainEqual({ kind: 'serving', on: false });
    expect(link.written.map(({ bytes }) => bytes)).toEqual([READ_33_REPLY, READ_33]);
  });

  test('stop with the port, and do not begin on the virtual bus', async () => {
    const { take, news, link } = await open({ kind: 'serve', on: true });
    expect(news).not.toContainEqual({ kind: 'serving', on: true });
    await take(port, { kind: 'serve', on: true });
    link.lose();
    await take();
    expect(news.filter(({ kind }) => kind === 'serving')).toEqual([
      { kind: 'serving', on: true },
      { kind: 'serving', on: false },
    ]);
  });
});
