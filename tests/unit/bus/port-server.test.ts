import { describe, expect, test } from 'vitest';
import {
  defaultRules,
  type LogLine,
  PortServer,
  sourceServers,
  type TransactionRules,
  VirtualBus,
} from '../../../src/bus/index.ts';
import { hex } from '../modbus/frames.ts';
import { ScriptedLink } from './scripted-link.ts';
import { VirtualClock } from './virtual-clock.ts';

const READ_33 = hex('21 03 03 E7 00 04 F3 1A');
const READ_33_REPLY = hex('21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18');
const READ_UNIT_2 = hex('02 03 00 00 00 01 84 39');
const UNIT_2_REPLY = hex('02 03 02 00 07 BD 86');
const SET_30_HZ = hex('06 06 02 AB 10 00 F5 E5');
const ILLEGAL_ADDRESS = hex('06 03 00 09 00 01 55 BF');
const ILLEGAL_ADDRESS_REPLY = hex('06 83 02 71 30');
/** 3.5 characters of 10 bits at 9600 baud are 3.65 ms. */
const T35 = 3.7;

function bench(rules: Partial<TransactionRules> = {}) {
  const clock = new VirtualClock();
  const link = new ScriptedLink(clock);
  const bus = new VirtualBus(clock, sourceServers(), () => 0x5a);
  bus.settings = { ...bus.settings, pace: 'fast', transport: rules.transport ?? 'rtu' };
  const log: LogLine[] = [];
  const server = new PortServer({
    link,
    clock,
    bus,
    rules: () => ({ ...defaultRules, ...rules }),
    log: (line) => log.push(line),
  });
  const hear = async (bytes: Uint8Array, pause = 20) => {
    link.receive(bytes);
    await clock.advance(pause);
  };
  const written = () => link.written.map(({ bytes }) => bytes);
  return { clock, link, bus, log, server, hear, written };
}

describe('virtual devices on a port', () => {
  test('answer a request behind its silence, and both are logged', async () => {
    const { clock, link, log, hear } = bench();
    await hear(READ_33);
    expect(link.written).toMatchObject([{ bytes: READ_33_REPLY }]);
    expect(link.written[0]?.at).toBeGreaterThanOrEqual(3.6);
    expect(link.written[0]?.at).toBeLessThan(T35 + 0.1);
    await clock.advance(500);
    expect(log).toMatchObject([
      { direction: 'received', kind: 'request', hex: '210303E70004F31A', time: 0 },
      { direction: 'sent', kind: 'reply', hex: '2103083039D4311A0A22B8C418' },
    ]);
    expect(log[1]?.time).toBeGreaterThanOrEqual(3.6);
  });

  test('take a request that an adapter hands over in two lumps, wherever it is cut', async () => {
    for (let cut = 1; cut < READ_33.length; cut++) {
      const { hear, written } = bench();
      await hear(READ_33.subarray(0, cut), 16);
      await hear(READ_33.subarray(cut));
      expect(written(), `cut behind ${cut}`).toEqual([READ_33_REPLY]);
    }
  });

  test('stay silent while others talk, also where all of it comes in one lump', async () => {
    const { hear, written, log } = bench();
    await hear(Uint8Array.from([...READ_UNIT_2, ...UNIT_2_REPLY, ...READ_33]));
    expect(written()).toEqual([READ_33_REPLY]);
    expect(log.map(({ kind }) => kind)).toEqual(['heard', 'heard', 'request', 'reply']);
  });

  test('obey a broadcast without a word', async () => {
    const { hear, written, bus, log } = bench();
    await hear(hex('00 06 02 AB 10 00 F5 83'));
    expect(written()).toEqual([]);
    expect(log).toMatchObject([{ kind: 'request' }]);
    const drive = bus.servers.find(({ unit }) => unit === 6);
    expect(drive?.tables['holding-register'].read(683, 1)).toEqual([0x1000]);
  });

  test('do not answer noise and broken frames, and count them', async () => {
    const { hear, written, bus, log } = bench();
    await hear(READ_33.with(7, 0x1b), 500);
    expect(written()).toEqual([]);
    expect(log).toMatchObject([{ kind: 'noise' }]);
    expect(bus.servers[0]?.counters.counts.busErrors).toBe(1);
  });

  test('make the faults that are asked for', async () => {
    const { hear, written, bus, log } = bench();
    bus.faults = [{ fault: { kind: 'bad-crc' }, unit: 33, times: 1 }];
    await hear(READ_33);
    expect(written()).toEqual([READ_33_REPLY.with(11, 0xc5)]);
    expect(log[1]?.kind).toBe('broken');
    await hear(READ_33);
    expect(written()[1]).toEqual(READ_33_REPLY);
  });

  test('do not answer their own echo, also where the reply is the request again', async () => {
    const { hear, written, log } = bench();
    await hear(SET_30_HZ);
    await hear(SET_30_HZ);
    await hear(READ_33);
    await hear(READ_33_REPLY);
    await hear(SET_30_HZ);
    await hear(SET_30_HZ);
    expect(written()).toEqual([SET_30_HZ, READ_33_REPLY, SET_30_HZ]);
    expect(log.map(({ kind }) => kind)).toEqual([
      ...['request', 'reply', 'echo'],
      ...['request', 'reply', 'echo'],
      ...['request', 'reply', 'echo'],
    ]);
  });

  test('do not answer their own echo, however late it comes', async () => {
    const { clock, hear, written, log } = bench();
    const asked = [READ_33, ILLEGAL_ADDRESS, SET_30_HZ];
    const answers = [READ_33_REPLY, ILLEGAL_ADDRESS_REPLY, SET_30_HZ];
    for (const [at, request] of asked.entries()) {
      await hear(request);
      await clock.advance(5000);
      await hear(answers[at]!, 500);
    }
    expect(written()).toEqual(answers);
    expect(log.map(({ kind }) => kind)).toEqual([
      ...['request', 'reply', 'echo'],
      ...['request', 'exception', 'echo'],
      ...['request', 'reply', 'echo'],
    ]);
  });

  test('see an echo that begins after others had told of none', async () => {
    const { hear, written } = bench();
    await hear(READ_33);
    await hear(READ_33);
    await hear(ILLEGAL_ADDRESS);
    await hear(ILLEGAL_ADDRESS_REPLY, 500);
    await hear(SET_30_HZ);
    await hear(SET_30_HZ, 500);
    expect(written()).toEqual([READ_33_REPLY, READ_33_REPLY, ILLEGAL_ADDRESS_REPLY, SET_30_HZ]);
  });

  test('answer a request that is repeated where the adapter has no echo', async () => {
    const { hear, written } = bench();
    await hear(READ_33);
    await hear(SET_30_HZ);
    await hear(SET_30_HZ);
    await hear(SET_30_HZ);
    expect(written()).toEqual([READ_33_REPLY, SET_30_HZ, SET_30_HZ, SET_30_HZ]);
  });

  test('answer in ASCII', async () => {
    const { hear, written } = bench({ transport: 'ascii' });
    const ascii = (text: string) => Uint8Array.from(text, (character) => character.charCodeAt(0));
    await hear(ascii(':210303E70004EE\r\n'));
    expect(written()).toEqual([ascii(':2103083039D4311A0A22B868\r\n')]);
  });

  test('say nothing any longer once they are stopped', async () => {
    const { hear, written, server, clock, link } = bench();
    link.receive(READ_33);
    await clock.advance(1);
    server.stop();
    await hear(READ_33, 500);
    expect(written()).toEqual([]);
  });
});
