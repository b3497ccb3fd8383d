import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  defaultSettings,
  type HeardNews,
  type HeardPiece,
  type LogLine,
  Session,
  type SessionNews,
  StreamSplitter,
} from '../../../src/bus/index.ts';
import { traceOf } from '../../../src/trace/index.ts';
import { recordsOfLines } from '../../../src/workbench/index.ts';
import { hex } from '../modbus/frames.ts';
import { ScriptedLink } from './scripted-link.ts';
import { VirtualClock } from './virtual-clock.ts';

// Unit 17, three registers from 107 on, as the guide PI-MBUS-300 asks for them.
const READ = hex('11 03 00 6B 00 03 76 87');
const THREE = hex('11 03 06 AE 41 56 52 43 40 49 AD');
const REFUSAL = hex('11 83 02 C1 34');
const ONE = hex('11 03 02 12 34 74 F0');
const WRITE = hex('11 06 00 01 00 03 9A 9B');
const text = (bytes: Uint8Array) => Buffer.from(bytes).toString('hex').toUpperCase();
const joined = (...parts: Uint8Array[]) => Uint8Array.from(parts.flatMap((part) => [...part]));

async function listening() {
  const clock = new VirtualClock();
  const link = new ScriptedLink(clock, { ...defaultSettings, baud: 9600, parity: 'none' });
  const told: SessionNews[] = [];
  const session = new Session({ clock, portLink: async () => link, tell: (news) => told.push(news) });
  await session.take({ kind: 'open-port', port: {}, settings: defaultSettings });
  const ended = session.take({ kind: 'start-job', id: 1, order: { kind: 'listen' }, confirmed: false });
  const lines = () => told.flatMap((one): readonly LogLine[] => (one.kind === 'lines' ? one.lines : []));
  const said = () => lines().map(({ direction, kind, hex, verdict }) => [direction, kind, hex, verdict]);
  const heard = () =>
    told.flatMap((one) => (one.kind === 'jobs' ? one.news.map(({ news }) => news as HeardNews) : [])).at(-1);
  return { clock, link, told, session, ended, lines, said, heard };
}

const count = { unit: 17, functionCode: 3, requests: 0, replies: 0, exceptions: 0, unanswered: 0, wrong: 0 };

describe('what others send', () => {
  test('is split, told apart, paired and counted', async () => {
    const { clock, link, lines, said, heard } = await listening();
    link.receive(READ);
    await clock.advance(30);
    link.receive(THREE);
    await clock.advance(500);
    link.receive(joined(READ, REFUSAL));
    await clock.advance(500);
    expect(said()).toEqual([
      ['sent', 'heard', text(READ), 'good'],
      ['received', 'heard', text(THREE), 'good'],
      ['sent', 'heard', text(READ), 'good'],
      ['received', 'heard', text(REFUSAL), 'refused'],
    ]);
    expect(lines().map(({ time }) => time)).toEqual([0, 30, 530, 530]);
    const trace = traceOf(recordsOfLines(lines()));
    expect(trace.exchanges(0, 9)).toMatchObject([
      { request: 0, replies: [1], after: 30_000 },
      { request: 2, replies: [3], faults: [{ kind: 'exception', exception: 2 }] },
    ]);
    expect(heard()).toEqual({
      kind: 'heard',
      frames: 4,
      noise: 0,
      counts: [{ ...count, requests: 2, replies: 1, exceptions: 1 }],
    });
  });

  test('is told apart where request and reply are the same, also when they come far apart', async () => {
    const { clock, link, said } = await listening();
    link.receive(WRITE);
    await clock.advance(400);
    link.receive(WRITE);
    await clock.advance(400);
    expect(said().map(([direction]) => direction)).toEqual(['sent', 'received']);
  });

  test('is counted as unanswered, or wrong, where it is', async () => {
    const { clock, link, heard, said } = await listening();
    link.receive(READ);
    await clock.advance(400);
    // Fewer registers than were asked for.
    link.receive(joined(READ, ONE));
    await clock.advance(400);
    link.receive(Uint8Array.of(0xff, 0x00, 0x55));
    await clock.advance(400);
    expect(heard()).toMatchObject({
      frames: 3,
      noise: 3,
      counts: [{ requests: 2, replies: 1, unanswered: 1, wrong: 1 }],
    });
    expect(said().at(-1)).toEqual(['received', 'noise', 'FF0055', undefined]);
  });

  test('comes out soon on a line that is never silent', async () => {
    const { clock, link, said } = await listening();
    for (let round = 0; round < 20; round++) {
      link.receive(READ);
      await clock.advance(20);
      link.receive(THREE);
      await clock.advance(30);
    }
    expect(said().length).toBeGreaterThan(20);
    expect(
      said()
        .slice(0, 2)
        .map(([direction]) => direction),
    ).toEqual(['sent', 'received']);
    await clock.advance(500);
    expect(said()).toHaveLength(40);
  });
});

describe('while this page listens', () => {
  test('it sends nothing, and says why', async () => {
    const { clock, link, told, session } = await listening();
    await session.take({ kind: 'send', id: 2, request: READ, confirmed: false });
    expect(told.at(-1)).toEqual({ kind: 'refused', id: 2, why: 'listening' });
    const order = { kind: 'poll', requests: [READ], interval: 100 } as const;
    await session.take({ kind: 'start-job', id: 3, order, confirmed: true });
    expect(told.at(-1)).toEqual({ kind: 'refused', id: 3, why: 'listening' });
    await clock.advance(1000);
    expect(link.written).toEqual([]);
  });

  test('stopping ends it, gives out what is left, and lets it send again', async () => {
    const { clock, link, told, session, ended, said } = await listening();
    link.receive(READ);
    await session.take({ kind: 'stop-job', id: 1 });
    await clock.until(ended);
    expect(said()).toEqual([['sent', 'heard', text(READ), 'good']]);
    expect(told.at(-1)).toEqual({ kind: 'job-ended', id: 1 });
    void session.take({ kind: 'send', id: 2, request: READ, confirmed: false });
    await clock.advance(500);
    expect(link.written).toHaveLength(1);
  });

  test('an adapter that is lost ends it', async () => {
    const { clock, link, told, ended } = await listening();
    link.lose();
    await clock.until(ended);
    expect(told.at(-1)).toEqual({ kind: 'job-ended', id: 1 });
  });
});

describe('the splitter', () => {
  const all = (pieces: readonly HeardPiece[]) => pieces.map(({ bytes }) => text(bytes)).join('');

  test('gives out every byte once and in order, however they come', () => {
    const frames = fc.constantFrom(
      READ,
      THREE,
      REFUSAL,
      ONE,
      WRITE,
      hex('3A 31 31 30 33 30 30 36 42 30 30 30 33 37 45 0D 0A'),
    );
    const chunk = fc.oneof(frames, fc.uint8Array({ maxLength: 700 }));
    fc.assert(
      fc.property(fc.array(fc.tuple(chunk, fc.constantFrom('add', 'split', 'end')), { maxLength: 12 }), (chunks) => {
        const splitter = new StreamSplitter();
        const heard: HeardPiece[] = [];
        for (const [bytes, then] of chunks) {
          heard.push(...splitter.add(bytes, 0));
          if (then === 'split') heard.push(...splitter.split());
          if (then === 'end') heard.push(...splitter.end());
        }
        heard.push(...splitter.end());
        expect(all(heard)).toBe(all(chunks.map(([bytes]) => ({ bytes, at: 0 }))));
      }),
    );
  });

  test('finds the same frames wherever the stream is cut', () => {
    const stream = joined(READ, THREE, READ, REFUSAL, WRITE, WRITE, READ, ONE);
    for (let cut = 1; cut < stream.length; cut++) {
      const splitter = new StreamSplitter();
      const heard = [
        ...splitter.add(stream.subarray(0, cut), 0),
        ...splitter.split(),
        ...splitter.add(stream.subarray(cut), 1),
        ...splitter.end(),
      ];
      expect(
        heard.map(({ bytes, frame }) => [frame?.direction, text(bytes)]),
        `cut at ${cut}`,
      ).toEqual([
        ['request', text(READ)],
        ['response', text(THREE)],
        ['request', text(READ)],
        ['response', text(REFUSAL)],
        ['request', text(WRITE)],
        ['response', text(WRITE)],
        ['request', text(READ)],
        ['response', text(ONE)],
      ]);
    }
  });
});
