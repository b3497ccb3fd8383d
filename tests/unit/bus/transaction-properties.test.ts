import fc from 'fast-check';
import { expect, test } from 'vitest';
import { BusClient, type BusEvent, type EchoRule } from '../../../src/bus/index.ts';
import { anyBytes } from '../modbus/arbitraries.ts';
import { hex } from '../modbus/frames.ts';
import { ScriptedLink } from './scripted-link.ts';
import { VirtualClock } from './virtual-clock.ts';

const READ = hex('11 03 00 6B 00 03 76 87');
const THREE = hex('11 03 06 AE 41 56 52 43 40 49 AD');
const WRITE = hex('11 06 00 01 00 03 9A 9B');

const request = fc.oneof(fc.constantFrom(READ, WRITE), anyBytes);
const piece = fc.record({
  after: fc.oneof(fc.nat(30), fc.nat(1500)),
  bytes: fc
    .oneof({ weight: 2, arbitrary: fc.constantFrom(READ, THREE, WRITE) }, anyBytes)
    .filter(({ length }) => length > 0),
});
const rules = fc.record({
  transport: fc.constantFrom('rtu' as const, 'ascii' as const),
  echo: fc.constantFrom<EchoRule>('auto', 'on', 'off'),
  retries: fc.nat(2),
  timeout: fc.integer({ min: 1, max: 500 }),
});

const total = (list: readonly { readonly bytes: Uint8Array }[]) =>
  list.reduce((sum, { bytes }) => sum + bytes.length, 0);

test('whatever comes, a transaction ends in time, and no byte of it is lost', async () => {
  await fc.assert(
    fc.asyncProperty(request, rules, fc.array(piece, { maxLength: 6 }), async (sent, how, pieces) => {
      const clock = new VirtualClock();
      const link = new ScriptedLink(clock);
      const client = new BusClient(link, clock, how);
      const events: BusEvent[] = [];
      client.listen((event) => events.push(event));
      link.replies.push(pieces);
      const { result } = client.transact(sent);
      const { outcome, strays, earlier, endedAt } = await clock.until(result);
      // Each sending has its time-out, and the time of the longest frame and of the request, or of a silence.
      const each = how.timeout + sent.length * 1.05 + 513 * 1.05 + 1100;
      expect(endedAt).toBeLessThan((how.retries + 1) * each + 3000);
      await clock.advance(5000);
      const outcomes = [outcome, ...earlier.map((attempt) => attempt.outcome)];
      const taken = total(outcomes.filter((one) => 'bytes' in one));
      const idle = total(events.flatMap((event) => (event.kind === 'stray' ? [event.stray] : [])));
      expect(taken + total(strays) + idle).toBe(total(pieces));
      expect(client.pending).toBe(0);
    }),
    { numRuns: 150 },
  );
});

test('a reply is found in whatever pieces it comes, with its echo and with noise around it', async () => {
  const noise = fc.uint8Array({ maxLength: 5 }).filter((bytes) => !bytes.includes(0x11));
  const cuts = fc.uniqueArray(fc.integer({ min: 1, max: READ.length + THREE.length + 9 }), { maxLength: 6 });
  await fc.assert(
    fc.asyncProperty(fc.boolean(), noise, cuts, async (echo, before, places) => {
      const all = Uint8Array.from([...(echo ? READ : []), ...before, ...THREE]);
      const clock = new VirtualClock();
      const link = new ScriptedLink(clock);
      const client = new BusClient(link, clock);
      const edges = [0, ...places.filter((place) => place < all.length).sort((a, b) => a - b), all.length];
      link.replies.push(edges.slice(1).map((end, i) => ({ after: 10 + 16 * i, bytes: all.subarray(edges[i], end) })));
      const result = await clock.until(client.transact(READ).result);
      expect(result).toMatchObject({ verdict: 'good', echo: echo ? 'removed' : 'none', outcome: { bytes: THREE } });
    }),
    { numRuns: 150 },
  );
});
