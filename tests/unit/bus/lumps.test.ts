import { describe, expect, test } from 'vitest';
import {
  defaultRules,
  defaultSettings,
  type LogLine,
  Session,
  type SessionNews,
  sourceSetups,
} from '../../../src/bus/index.ts';
import { hex } from '../modbus/frames.ts';
import { ScriptedLink } from './scripted-link.ts';
import { VirtualClock } from './virtual-clock.ts';

// Unit 17, three registers from 107 on, as the guide PI-MBUS-300 asks for them.
const READ = hex('11 03 00 6B 00 03 76 87');
const THREE = hex('11 03 06 AE 41 56 52 43 40 49 AD');
const WRITE = hex('11 06 00 01 00 03 9A 9B');

const joined = (...parts: Uint8Array[]) => Uint8Array.from(parts.flatMap((part) => [...part]));
/** Bytes in which no frame of unit 17 begins. */
const noise = (length: number) => Uint8Array.from({ length }, (_, at) => 0x80 + ((at * 7) % 101));
const text = (bytes: Uint8Array) => Buffer.from(bytes).toString('hex').toUpperCase();

async function open() {
  const clock = new VirtualClock();
  const link = new ScriptedLink(clock, { ...defaultSettings, baud: 9600, parity: 'none' });
  const told: SessionNews[] = [];
  const session = new Session({ clock, portLink: async () => link, tell: (news) => told.push(news) });
  await session.take({ kind: 'open-port', port: {}, settings: defaultSettings });
  await session.take({ kind: 'set-rules', rules: { ...defaultRules, timeout: 500, echo: 'off' } });
  const lines = () => told.flatMap((one): readonly LogLine[] => (one.kind === 'lines' ? one.lines : []));
  const received = () => lines().filter(({ direction }) => direction === 'received');
  return { clock, link, session, lines, received };
}

/** What was received stands in the log, in order, and in pieces that are no longer than a frame. */
function expectAll(lines: readonly LogLine[], bytes: Uint8Array) {
  expect(lines.map((line) => line.hex).join('')).toBe(text(bytes));
  for (const line of lines) expect(line.hex.length).toBeLessThanOrEqual(2 * 256);
}

describe('many bytes in one write', () => {
  test.each([500, 1026, 1027, 1500, 3000, 4096])('%i bytes while nothing is asked', async (length) => {
    const { clock, link, received } = await open();
    link.receive(noise(length));
    await clock.advance(1000);
    expectAll(received(), noise(length));
  });

  test('300 frames while nothing is asked are 300 lines', async () => {
    const { clock, link, received } = await open();
    link.receive(joined(...Array.from({ length: 300 }, () => WRITE)));
    await clock.advance(1000);
    expect(received()).toHaveLength(300);
    expect(new Set(received().map((line) => line.hex))).toEqual(new Set([text(WRITE)]));
  });

  test.each([500, 2000, 3000])('the reply that is waited for and %i more bytes', async (length) => {
    const { clock, link, session, lines, received } = await open();
    link.replies.push([{ after: 20, bytes: joined(THREE, noise(length)) }]);
    const sent = session.take({ kind: 'send', id: 1, request: READ, confirmed: false });
    await clock.advance(3000);
    await sent;
    expect(lines()[0]).toMatchObject({ kind: 'request', verdict: 'good' });
    expect(received()[0]).toMatchObject({ kind: 'reply', hex: text(THREE) });
    expectAll(received(), joined(THREE, noise(length)));
  });

  test.each([500, 2000, 3000])('%i bytes and the reply behind them', async (length) => {
    const { clock, link, session, lines, received } = await open();
    link.replies.push([{ after: 20, bytes: joined(noise(length), THREE) }]);
    const sent = session.take({ kind: 'send', id: 1, request: READ, confirmed: false });
    await clock.advance(3000);
    await sent;
    expect(lines()[0]).toMatchObject({ kind: 'request', verdict: 'good' });
    expectAll(received(), joined(noise(length), THREE));
  });

  test.each([500, 2000, 3000])('%i bytes in place of a reply', async (length) => {
    const { clock, link, session, received } = await open();
    link.replies.push([{ after: 20, bytes: noise(length) }]);
    const sent = session.take({ kind: 'send', id: 1, request: READ, confirmed: false });
    await clock.advance(3000);
    await sent;
    expectAll(received(), noise(length));
  });

  test.each([0, 500, 2000, 3000])('%i zeros and a request to a virtual device', async (length) => {
    const { clock, link, session, lines, received } = await open();
    await session.take({ kind: 'virtual', order: { kind: 'devices', devices: sourceSetups() } });
    await session.take({ kind: 'serve', on: true });
    const request = hex('21 03 03 E7 00 04 F3 1A');
    link.receive(joined(new Uint8Array(length), request));
    await clock.advance(1000);
    expectAll(received(), joined(new Uint8Array(length), request));
    expect(lines().filter(({ direction }) => direction === 'sent')).toMatchObject([{ kind: 'reply' }]);
  });

  test.each([500, 2000, 3000])('%i bytes and a request while the page listens', async (length) => {
    const { clock, link, session, lines } = await open();
    void session.take({ kind: 'start-job', id: 1, order: { kind: 'listen' }, confirmed: false });
    await clock.advance(1);
    link.receive(joined(noise(length), READ));
    await clock.advance(1000);
    expectAll(lines(), joined(noise(length), READ));
  });
});
