import { describe, expect, it } from 'vitest';
import { BusClient, type JobOrder, type LogLine } from '../../../src/bus/index.ts';
import { startJob } from '../../../src/bus/jobs/index.ts';
import { fromHex } from '../../../src/modbus/index.ts';
import { ScriptedLink } from './scripted-link.ts';
import { VirtualClock } from './virtual-clock.ts';

const bytes = (hex: string) => fromHex(hex) as Uint8Array;
// Unit, function, start address, quantity, CRC.
const READ = bytes('0103000A0002E409');
// Unit, function with the bit of an exception, code, CRC.
const REFUSED = bytes('018302C0F1');
const TIMEOUT = 20_000;

const orders = {
  poll: { kind: 'poll', requests: [READ], interval: 0 },
  read: {
    kind: 'read',
    transport: 'rtu',
    wanted: [{ unit: 1, table: 'holding-register', address: 10, size: 2 }],
    rules: { gap: 0, registers: 125, bits: 2000 },
  },
  trials: { kind: 'trials', transport: 'rtu', trials: [{ request: READ, rules: {} }] },
  scan: { kind: 'scan', what: 'units', transport: 'rtu', timeout: TIMEOUT, first: 1, last: 3, lines: [] },
  sequence: {
    kind: 'sequence',
    sequence: { transport: 'rtu', steps: [{ kind: 'send', bytes: READ, onFailure: 'stop' }], finally: [] },
  },
} as unknown as Record<string, JobOrder>;

function bench() {
  const clock = new VirtualClock();
  const link = new ScriptedLink(clock);
  const client = new BusClient(link, clock, { timeout: TIMEOUT });
  const told: unknown[] = [];
  const start = (order: JobOrder) =>
    startJob(order, {
      client,
      clock,
      link,
      reopen: () => Promise.resolve(true),
      log: (_: LogLine) => undefined,
      tell: (news) => told.push(news),
    });
  return { clock, link, client, start, told };
}

describe('a job that is stopped while its request waits to be sent', () => {
  it.each(Object.entries(orders))('ends at once and does not send it: %s', async (_, order) => {
    const { clock, link, client, start } = bench();
    // Nobody answers this one, so that everything behind it waits.
    client.transact(READ);
    await clock.advance(10);
    const job = start(order);
    await clock.advance(10);
    const before = clock.now();
    job.stop();
    await clock.until(job.ended);
    expect(clock.now() - before).toBeLessThan(5);
    await clock.advance(3 * TIMEOUT);
    expect(link.written).toHaveLength(1);
  });

  it('ends at once in the pause behind an exception, and the log of it stays', async () => {
    const { clock, link, start, told } = bench();
    link.replies.push([{ bytes: REFUSED, after: 5 }]);
    const job = start(orders['poll'] as JobOrder);
    await clock.advance(1000);
    job.stop();
    await clock.until(job.ended);
    expect(clock.now()).toBeLessThan(1100);
    expect(told).toMatchObject([{ kind: 'sample', outcome: 'exception' }]);
    expect(link.written).toHaveLength(1);
  });
});
