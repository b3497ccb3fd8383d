import { describe, expect, it } from 'vitest';
import type { PollSample } from '../../../../src/bus/index.ts';
import { plainRegister, type Register } from '../../../../src/devices/index.ts';
import { chartData } from '../../../../src/workbench/bus/chart-data.ts';
import { heldBy, numberOf, type PollSource } from '../../../../src/workbench/bus/poll-source.ts';
import { MOST_DRAWN, newPolled, type Polled, withDrawn, withSample } from '../../../../src/workbench/bus/polled.ts';
import { framed } from '../../bus/late-line.ts';
import { hex } from '../../modbus/frames.ts';

// Unit 17, registers 107 to 109, and coils 0 to 7 of the same unit.
const READ = hex('11 03 00 6B 00 03 76 87');
const THREE = hex('11 03 06 AE 41 56 52 43 40 49 AD');
const REFUSAL = hex('11 83 02 C1 34');

const value = (at: number, type: 'u16' | 'u32' | 'text', size = 1) => ({
  name: `${type} at ${at}`,
  place: '',
  register: { ...plainRegister, name: '', table: 'holding-register', address: 107 + at, type, factor: 0.5 } as const,
  where: { read: 0, at, size },
});
const source: PollSource = {
  title: '',
  transport: 'rtu',
  requests: [READ],
  reads: [{ quantity: 3, width: 1 }],
  values: [value(0, 'u16'), value(1, 'u32', 2)],
  unreadable: [],
};
const sample = (change: Partial<PollSample>): PollSample => ({
  kind: 'sample',
  index: 0,
  round: 0,
  time: 1000,
  outcome: 'silent',
  verdict: 'bad',
  ...change,
});

it('a value of a poll is what its line says of the number', () => {
  const line = (more: Partial<Register>) => ({
    ...value(0, 'u16'),
    register: { ...value(0, 'u16').register, ...more },
  });
  const number = (more: Partial<Register>, raw: number) => {
    const held = heldBy(line(more), [raw]);
    return held === undefined ? undefined : numberOf(held, line(more));
  };
  expect(number({}, 490)).toBe(245);
  expect(number({ mask: 0xff00, factor: 1 }, 0x191e)).toBe(0x19);
  expect(number({ notImplemented: '65535' }, 65535)).toBeUndefined();
  // The power of ten stands in another register, which was not read with it.
  expect(number({ scaleRegister: { address: 108 }, unit: 'W' }, 5003)).toBeUndefined();
});

describe('a line whose power of ten stands in another register', () => {
  const W = { ...plainRegister, name: 'W', table: 'holding-register', address: 107, unit: 'W' } as const;
  const scaled = (power: { read: number; at: number }): PollSource => ({
    ...source,
    requests: [READ, READ],
    reads: [...source.reads, ...source.reads],
    values: [
      {
        name: 'W',
        place: '',
        register: { ...W, scaleRegister: { address: 109 }, notImplemented: '0xFFFF' },
        where: { read: 0, at: 0, size: 1 },
        power: { ...power, size: 1 },
      },
    ],
  });
  /** Registers 107 to 109 of unit 17. */
  const reply = (...words: readonly number[]) =>
    ({
      outcome: 'reply',
      reply: framed(17, 3, 6, ...words.flatMap((word) => [word >> 8, word & 0xff])),
    }) as const;
  const polledBy = (of: PollSource, ...all: readonly Partial<PollSample>[]) =>
    all.reduce<Polled>((polled, one) => withSample(polled, sample(one), true), newPolled(of, 0));
  const inSame = scaled({ read: 0, at: 2 });
  const inNext = scaled({ read: 1, at: 2 });
  const last = ({ samples, powers }: Polled) => [samples.last[0], powers[0], samples.valueOf(0, samples.length - 1)];

  it('counts with that power, positive or negative', () => {
    // 5003 × 10^-2, 5003 × 10^1
    expect(last(polledBy(inSame, reply(5003, 0, 0xfffe)))).toEqual([5003, -2, 50.03]);
    expect(last(polledBy(inSame, reply(5003, 0, 1)))).toEqual([5003, 1, 50_030]);
  });

  it('counts when the power has come too, with that of its own round', () => {
    const first = polledBy(inNext, reply(5003, 0, 7));
    expect(last(first)).toEqual([undefined, undefined, undefined]);
    expect(first.samples.statistics[0]?.tries).toBe(0);
    const whole = [reply(5003, 0, 7), { index: 1, ...reply(0, 0, 0xfffe) }];
    expect(last(polledBy(inNext, ...whole))).toEqual([5003, -2, 50.03]);
    expect(last(polledBy(inNext, ...whole, reply(42, 0, 7), { index: 1, ...reply(0, 0, 0) }))).toEqual([42, 0, 42]);
  });

  it('is shown as it is, and not drawn, while the power is not known', () => {
    // 0x8000 is SunSpec's “no scale”; an exception came in place of the second reply.
    for (const polled of [
      polledBy(inSame, reply(5003, 0, 0x8000)),
      polledBy(inSame, reply(5003, 0, 11)),
      polledBy(inNext, reply(5003, 0, 0), { index: 1, outcome: 'exception', reply: REFUSAL }),
    ]) {
      expect(last(polled)).toEqual([5003, undefined, undefined]);
      expect(polled.samples.statistics[0]).toMatchObject({ errors: 0, mean: undefined });
    }
  });

  it('is neither drawn nor counted where the device says that it has no such value', () => {
    const polled = polledBy(inSame, reply(0xffff, 0, 0));
    expect(last(polled)).toEqual([0xffff, 0, undefined]);
    expect(chartData(polled.samples, [0], 0)).toEqual([[1], [null]]);
  });

  it('fails with its own reply, and is doubtful with either of both', () => {
    const lost = polledBy(inNext, { outcome: 'silent' }, { index: 1, ...reply(0, 0, 0) });
    expect(lost.samples.statistics[0]).toMatchObject({ errors: 1, tries: 1 });
    const doubtful = { index: 1, unsure: 'perhaps-late', verdict: 'doubtful', ...reply(0, 0, 0) } as const;
    expect(polledBy(inNext, reply(5003, 0, 0), doubtful).samples.statistics[0]).toMatchObject({
      errors: 0,
      doubtful: 1,
    });
  });
});

describe('what a request of a poll has come to', () => {
  it('is the values in the reply, in their units', () => {
    const polled = withSample(newPolled(source, 500), sample({ outcome: 'reply', reply: THREE }), true);
    expect(polled).toMatchObject({ interval: 500, requests: 1, failed: 0, items: [[0xae41], [0x5652, 0x4340]] });
    expect(polled.samples.last).toEqual([0xae41, 0x56524340]);
    // The value is half the number in a register.
    expect([0, 1].map((index) => polled.samples.valueOf(index, 0))).toEqual([0xae41 / 2, 0x56524340 / 2]);
  });

  it('is a failure of all its values when no reply can be read', () => {
    let polled = newPolled(source, 0);
    for (const change of [
      { outcome: 'silent' },
      { outcome: 'exception', reply: REFUSAL },
      { outcome: 'not-sent' },
    ] as const)
      polled = withSample(polled, sample(change), true);
    expect(polled).toMatchObject({ requests: 3, failed: 3, items: [undefined, undefined] });
    expect(polled.samples.statistics.map(({ errors }) => errors)).toEqual([3, 3]);
  });

  it('keeps why each value failed, and how often each reason came', () => {
    const refused = { outcome: 'exception', verdict: 'refused', exceptionCode: 2, reply: REFUSAL } as const;
    let polled = newPolled(source, 0);
    for (const change of [refused, refused, { outcome: 'silent' }] as const)
      polled = withSample(polled, sample(change), true);
    const silence = { outcome: 'silent', verdict: 'bad' };
    const refusal = { outcome: 'exception', verdict: 'refused', exceptionCode: 2 };
    expect(polled.failures).toEqual([silence, silence]);
    expect(polled.reasons).toEqual([
      { failure: refusal, count: 2 },
      { failure: silence, count: 1 },
    ]);
    polled = withSample(polled, sample({ outcome: 'reply', verdict: 'good', reply: THREE }), true);
    expect(polled.failures).toEqual([undefined, undefined]);
    expect(polled.reasons).toHaveLength(2);
  });

  it('fails those values only whose request failed', () => {
    const two = { ...source, requests: [READ, READ], reads: [...source.reads, ...source.reads] };
    const [first, second] = two.values;
    const values = [first, second && { ...second, where: { ...second.where, read: 1 } }].flatMap((one) => one ?? []);
    let polled = withSample(newPolled({ ...two, values }, 0), sample({ outcome: 'reply', reply: THREE }), true);
    polled = withSample(polled, sample({ index: 1, outcome: 'exception', exceptionCode: 4, reply: REFUSAL }), true);
    expect(polled.failures.map((failure) => failure?.exceptionCode)).toEqual([undefined, 4]);
  });

  it('is no value, and no failure, when the reply may be that to another request', () => {
    const change = { outcome: 'reply', verdict: 'doubtful', unsure: 'perhaps-late', reply: THREE, slow: 1300 } as const;
    const polled = withSample(newPolled(source, 0), sample(change), true);
    expect(polled).toMatchObject({ requests: 1, failed: 0, doubtful: 1, slow: 1300, items: [undefined, undefined] });
    expect(polled.samples.last).toEqual([undefined, undefined]);
    expect(polled.samples.valueOf(0, 0)).toBeUndefined();
    const [first] = polled.samples.statistics;
    expect(first).toMatchObject({
      tries: 1,
      errors: 0,
      doubtful: 1,
      isDoubtful: true,
      lastAt: undefined,
      mean: undefined,
    });
  });

  it('is nothing when there was no line to ask on, but for a gap', () => {
    let polled = newPolled(source, 0);
    for (const outcome of ['lost', 'cancelled', 'not-sent'] as const)
      polled = withSample(polled, sample({ outcome }), false);
    expect(polled).toMatchObject({ requests: 0, failed: 0 });
    expect(polled.samples.rounds).toBe(3);
    expect(polled.samples.statistics[0]?.tries).toBe(0);
  });

  it('begins a round with the first request only', () => {
    const two = { ...source, requests: [READ, READ], reads: [...source.reads, ...source.reads] };
    let polled = newPolled(two, 0);
    for (const index of [0, 1, 2]) polled = withSample(polled, sample({ index, outcome: 'reply', reply: THREE }), true);
    // A request that is not of this poll changes nothing.
    expect(polled).toMatchObject({ requests: 2 });
    expect(polled.samples.rounds).toBe(1);
  });
});

describe('the values that are drawn', () => {
  const many = { ...source, values: [value(0, 'text'), ...Array.from({ length: 12 }, () => value(0, 'u16'))] };

  it('are the first numbers, then those that are chosen, in their order', () => {
    const polled = newPolled(many, 0);
    expect(polled.drawn).toEqual([1, 2, 3]);
    expect(withDrawn(withDrawn(polled, 9, true), 2, false).drawn).toEqual([1, 3, 9]);
    expect(withDrawn(withDrawn(polled, 9, true), 5, true).drawn).toEqual([1, 2, 3, 5, 9]);
    expect(withDrawn(polled, 2, true).drawn).toEqual([1, 2, 3]);
  });

  it('are eight at most', () => {
    let polled = newPolled(many, 0);
    for (let number = 4; number < 12; number++) polled = withDrawn(polled, number, true);
    expect(polled.drawn).toHaveLength(MOST_DRAWN);
    expect(withDrawn(polled, 11, true)).toBe(polled);
    expect(withDrawn(withDrawn(polled, 1, false), 11, true).drawn.at(-1)).toBe(11);
  });
});
