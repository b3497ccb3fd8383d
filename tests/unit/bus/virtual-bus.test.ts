import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  BusClient,
  defaultSettings,
  type Fault,
  type LinkSettings,
  sourceServers,
  type TransactionRules,
  VirtualBus,
  type VirtualBusEvent,
  VirtualLink,
} from '../../../src/bus/index.ts';
import { anyBytes } from '../modbus/arbitraries.ts';
import { hex } from '../modbus/frames.ts';
import { VirtualClock } from './virtual-clock.ts';

const settings: LinkSettings = { ...defaultSettings, baud: 9600, parity: 'none' };

// The frames of the sources.
const MODICON = hex('21 03 03 E7 00 04 F3 1A');
const MODICON_REPLY = hex('21 03 08 30 39 D4 31 1A 0A 22 B8 C4 18');
const SET_30_HZ = hex('06 06 02 AB 10 00 F5 E5');
const RUN = hex('06 06 02 AA 00 01 68 25');
const STOP = hex('06 06 02 AA 00 00 A9 E5');
const READ_SPEED = hex('06 03 02 A9 00 01 54 25');

const text = (bytes: Uint8Array) => Buffer.from(bytes).toString('hex').toUpperCase();

async function bench(rules: Partial<TransactionRules> = {}, line = settings) {
  const clock = new VirtualClock();
  const bus = new VirtualBus(clock, sourceServers(), () => 0x5a);
  const link = new VirtualLink(bus, clock);
  const client = new BusClient(link, clock, rules);
  const events: VirtualBusEvent[] = [];
  bus.listen((event) => events.push(event));
  await link.open(line);
  const ask = (request: Uint8Array) => clock.until(client.transact(request).result);
  return { clock, bus, link, client, events, ask };
}

const registers = { outcome: { kind: 'reply' as const } };

describe('the devices of the sources', () => {
  test('stand at their addresses; one answers, and all hear', async () => {
    const { ask, events } = await bench();
    const result = await ask(MODICON);
    expect(result).toMatchObject({ verdict: 'good', outcome: { kind: 'reply', bytes: MODICON_REPLY } });
    const heard = events.flatMap((event) =>
      event.kind === 'heard' ? [[event.server.unit, event.does, event.why]] : [],
    );
    expect(heard).toEqual([
      [1, 'nothing', 'other-unit'],
      [6, 'nothing', 'other-unit'],
      [9, 'nothing', 'other-unit'],
      [17, 'nothing', 'other-unit'],
      [33, 'answer', undefined],
    ]);
    expect(events.map(({ kind }) => kind).filter((kind) => kind !== 'heard')).toEqual(['request', 'reply']);
  });

  test('hear a broadcast, all of them, and say nothing', async () => {
    const { ask, events, bus } = await bench();
    expect(await ask(hex('00 06 00 01 00 03 99 DA'))).toMatchObject({ outcome: { kind: 'sent' } });
    expect(await ask(hex('01 03 00 01 00 01 D5 CA'))).toMatchObject({ verdict: 'good' });
    expect(events.filter((event) => event.kind === 'heard' && event.why === 'broadcast')).toHaveLength(5);
    expect(bus.servers[0]?.tables['holding-register'].read(1, 1)).toEqual([3]);
  });

  test('the I-8xx7 reads inputs where it reads coils', async () => {
    const { ask } = await bench();
    // Eight bits from address 2, as its example over TCP has them: 49.
    const coils = await ask(hex('09 01 00 02 00 08 9D 44'));
    expect(coils.outcome).toHaveProperty('bytes', hex('09 01 01 49 92 1E'));
    const inputs = await ask(hex('09 02 00 02 00 08 D9 44'));
    expect(inputs.outcome).toHaveProperty('bytes', hex('09 02 01 49 62 1E'));
  });

  test('the speed of the drive follows its reference', async () => {
    const { ask, clock } = await bench();
    const speed = async () => {
      const { outcome } = await ask(READ_SPEED);
      return outcome.kind === 'reply' ? (outcome.reading.fields['registers'] as number[])[0] : undefined;
    };
    expect(await ask(SET_30_HZ)).toMatchObject(registers);
    await clock.advance(1000);
    expect(await speed(), 'it stands until it is told to run').toBe(0);
    expect(await ask(RUN)).toMatchObject(registers);
    await clock.advance(1000);
    const after = await speed();
    expect(after).toBeGreaterThan(1500);
    expect(after).toBeLessThan(2000);
    await clock.advance(3000);
    expect(await speed(), '30 of 60 Hz').toBe(4096);
    expect(await ask(STOP)).toMatchObject(registers);
    await clock.advance(3000);
    expect(await speed()).toBe(0);
  });
});

describe('time', () => {
  test('on a line of 9600 baud takes what characters, silence and work take', async () => {
    const { ask } = await bench();
    const result = await ask(MODICON);
    // 8 and 13 characters of 10 bits, 3.5 characters of silence before the device knows the end, and its 2 ms.
    expect(result.endedAt - (result.sentAt ?? 0)).toBeCloseTo((8 + 3.5 + 13) * (10_000 / 9600) + 2, 6);
  });

  test('as fast as it can takes none, and late replies are late all the same', async () => {
    const { ask, bus } = await bench({ gap: 0 });
    bus.settings = { ...bus.settings, pace: 'fast' };
    expect(await ask(MODICON)).toMatchObject({ verdict: 'good', endedAt: 0 });
    bus.faults = [{ fault: { kind: 'late', by: 300 }, times: 1 }];
    expect(await ask(MODICON)).toMatchObject({ verdict: 'good', endedAt: 300 });
  });

  test('an adapter that hands over in lumps changes nothing but when', async () => {
    const { ask, bus } = await bench();
    bus.settings = { ...bus.settings, lump: 4 };
    expect(await ask(MODICON)).toMatchObject({ verdict: 'good', outcome: { bytes: MODICON_REPLY } });
  });

  test('a device whose line is set otherwise hears noise', async () => {
    const { ask, bus, events } = await bench({ timeout: 200 });
    for (const server of bus.servers) server.line = { baud: 19_200, dataBits: 8, parity: 'even', stopBits: 1 };
    expect(await ask(MODICON)).toMatchObject({ outcome: { kind: 'silent' } });
    expect(events.filter((event) => event.kind === 'heard' && event.why === 'other-settings')).toHaveLength(5);
    expect(bus.servers[0]?.counters.counts.busErrors).toBe(1);
  });
});

describe('faults', () => {
  const asked = async (fault: Fault, rules: Partial<TransactionRules> = {}) => {
    const made = await bench({ timeout: 300, ...rules });
    made.bus.faults = [{ fault, unit: 33, times: 1 }];
    const first = await made.ask(MODICON);
    return { ...made, first, second: await made.ask(MODICON) };
  };

  test.each<readonly [Fault, object]>([
    [{ kind: 'silence' }, { verdict: 'bad', outcome: { kind: 'silent' } }],
    [
      { kind: 'exception', exceptionCode: 6 },
      { verdict: 'refused', outcome: { exceptionCode: 6 } },
    ],
    [{ kind: 'bad-crc' }, { verdict: 'bad', outcome: { kind: 'broken' }, findings: [{ code: 'bit-error' }] }],
    [
      { kind: 'cut-off', keep: 7 },
      { verdict: 'bad', outcome: { kind: 'broken' }, findings: [{ code: 'truncated' }] },
    ],
    [
      { kind: 'byte-loss' },
      { verdict: 'bad', outcome: { kind: 'broken' }, findings: [{ code: 'truncated', missing: 1 }] },
    ],
    [{ kind: 'echo' }, { verdict: 'good', echo: 'removed', strays: [{ what: 'echo', bytes: MODICON }] }],
    [
      { kind: 'noise', bytes: 3 },
      { verdict: 'good', strays: [{ what: 'noise', bytes: hex('5A 5A 5A') }] },
    ],
    [{ kind: 'merged' }, { verdict: 'good', strays: [{ what: 'copy', bytes: MODICON_REPLY }] }],
    [
      { kind: 'late', by: 500 },
      { verdict: 'bad', outcome: { kind: 'silent' } },
    ],
  ])('%o happens once, and is seen', async (fault, seen) => {
    const { first, second } = await asked(fault);
    expect({ ...first, findings: first.findings.slice(0, 1) }).toMatchObject(seen);
    expect(second).toMatchObject({ outcome: { kind: 'reply', bytes: MODICON_REPLY } });
    // Behind silence, the reply may be the one to the first request, and another is waited for.
    const least = fault.kind === 'silence' ? 300 : 0;
    expect(second.verdict).toBe(fault.kind === 'silence' ? 'doubtful' : 'good');
    expect(second.endedAt - (second.sentAt ?? 0)).toBeGreaterThanOrEqual(least);
    expect(second.endedAt - (second.sentAt ?? 0)).toBeLessThan(least + 50);
  });

  test('happen to the device they are for, as long as they stand', async () => {
    const { bus, ask } = await bench({ timeout: 300 });
    bus.faults = [{ fault: { kind: 'silence' }, unit: 6 }];
    expect(await ask(MODICON)).toMatchObject({ verdict: 'good' });
    expect(await ask(READ_SPEED)).toMatchObject({ outcome: { kind: 'silent' } });
    expect(await ask(READ_SPEED)).toMatchObject({ outcome: { kind: 'silent' } });
    bus.faults = [];
    expect(await ask(READ_SPEED)).toMatchObject({ outcome: { kind: 'reply' } });
  });

  test('a request that is refused by a fault is not carried out', async () => {
    const { bus, ask } = await bench();
    bus.faults = [{ fault: { kind: 'exception', exceptionCode: 4 } }];
    await ask(SET_30_HZ);
    expect(bus.servers.find(({ unit }) => unit === 6)?.tables['holding-register'].read(683, 1)).toEqual([0]);
  });
});

test('whatever is sent and whatever is to go wrong, the transaction ends', async () => {
  const number = fc.integer({ min: -5, max: 400 });
  const fault = fc.oneof(
    fc.constantFrom<Fault>(
      ...(['silence', 'bad-crc', 'echo', 'merged', 'byte-loss'] as const).map((kind) => ({ kind })),
    ),
    number.map((by): Fault => ({ kind: 'late', by })),
    number.map((exceptionCode): Fault => ({ kind: 'exception', exceptionCode })),
    number.map((keep): Fault => ({ kind: 'cut-off', keep })),
    number.map((bytes): Fault => ({ kind: 'noise', bytes })),
  );
  const request = fc.oneof(fc.constantFrom(MODICON, RUN, READ_SPEED), anyBytes);
  await fc.assert(
    fc.asyncProperty(request, fault, async (bytes, what) => {
      const { ask, bus } = await bench({ timeout: 200 });
      bus.faults = [{ fault: what }];
      expect(['good', 'doubtful', 'refused', 'bad']).toContain((await ask(bytes)).verdict);
    }),
    { numRuns: 60 },
  );
});

test('a wrong LRC is one digit that is another', async () => {
  const { bus, ask } = await bench({ transport: 'ascii' });
  bus.settings = { ...bus.settings, transport: 'ascii' };
  bus.faults = [{ fault: { kind: 'bad-crc' } }];
  const result = await ask(new TextEncoder().encode(':1103006B00037E\r\n'));
  // The LRC is 55.
  expect(result).toMatchObject({ outcome: { bytes: new TextEncoder().encode(':110306022B0000006450\r\n') } });
  expect(result.findings[0]).toMatchObject({ code: 'lrc-wrong', got: 0x50, expected: 0x55 });
});

describe('the plug', () => {
  test('an adapter that echoes is found out', async () => {
    const { bus, ask } = await bench();
    bus.settings = { ...bus.settings, echo: true };
    expect(await ask(SET_30_HZ)).toMatchObject({ verdict: 'good', echo: 'removed' });
    expect(await ask(MODICON)).toMatchObject({ verdict: 'good', echo: 'removed', outcome: { bytes: MODICON_REPLY } });
  });

  test('pulled out while a reply is on its way, nothing of it comes, also not after it is put back', async () => {
    const { client, clock, link } = await bench();
    const { result } = client.transact(MODICON);
    await clock.advance(15);
    link.unplug();
    expect(await clock.until(result)).toMatchObject({ verdict: 'ended', outcome: { kind: 'lost', stage: 'waiting' } });
    expect(link.state).toMatchObject({ kind: 'lost', why: 'unplugged' });
    expect(await link.write(MODICON)).toBe(false);
    await link.open(settings);
    const received: string[] = [];
    link.listen((event) => event.kind === 'received' && received.push(text(event.bytes)));
    await clock.advance(1000);
    expect(received).toEqual([]);
    expect(await clock.until(client.transact(MODICON).result)).toMatchObject({ verdict: 'good' });
  });

  test('in ASCII', async () => {
    const { bus, ask } = await bench({ transport: 'ascii' });
    bus.settings = { ...bus.settings, transport: 'ascii' };
    const result = await ask(new TextEncoder().encode(':1103006B00037E\r\n'));
    expect(result).toMatchObject({ verdict: 'good', outcome: { kind: 'reply' } });
    expect(result.outcome).toHaveProperty('reading.fields.registers', [555, 0, 100]);
  });
});
