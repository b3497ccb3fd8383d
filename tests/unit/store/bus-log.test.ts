import { signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import type { LogLine } from '../../../src/bus/index.ts';
import { BusLog } from '../../../src/store/bus-log.ts';
import { MOST_RECORDS, type TraceState } from '../../../src/store/index.ts';
import type { TraceInput } from '../../../src/trace/index.ts';

/** A line whose time says which it is, in milliseconds. */
const line = (number: number): LogLine => ({
  time: number,
  direction: 'sent',
  transport: 'rtu',
  kind: 'request',
  hex: '1103006B00037687',
});
const lines = (from: number, to: number) => Array.from({ length: to - from + 1 }, (_, at) => line(from + at));

/** A log, and the numbers of the lines that its trace shows. */
function setUp() {
  const state = signal<TraceState>({ kind: 'empty' });
  let shown: number[] = [];
  const numberOf = ({ time = Number.NaN }: TraceInput) => time / 1000;
  const log = new BusLog({
    state,
    append(records) {
      state.value = { kind: 'open', name: undefined, format: '' };
      shown.push(...records.map(numberOf));
    },
    clear() {
      shown = [];
    },
  });
  const dies = () => {
    shown = [];
    state.value = { kind: 'failed', name: undefined, code: 'died' };
  };
  return { log, shown: () => shown, kept: () => log.records.map(numberOf), dies };
}

describe('the log of the bus', () => {
  it('is shown as it comes, is cleared, and brought back until others come', () => {
    const { log, shown, kept } = setUp();
    log.add([line(1), line(2)]);
    log.add([line(3)]);
    expect([shown(), kept()]).toEqual([
      [1, 2, 3],
      [1, 2, 3],
    ]);
    log.clear();
    expect([shown(), kept(), log.cleared.value]).toEqual([[], [], 3]);
    log.bringBack();
    expect([shown(), kept(), log.cleared.value]).toEqual([[1, 2, 3], [1, 2, 3], 0]);
    log.clear();
    log.add([line(4)]);
    expect([shown(), log.cleared.value]).toEqual([[4], 0]);
    log.bringBack();
    expect(kept()).toEqual([]);
  });

  it('keeps its last 100,000 records', () => {
    const { log, kept } = setUp();
    log.add(lines(1, MOST_RECORDS));
    log.add(lines(MOST_RECORDS + 1, MOST_RECORDS + 2));
    expect([kept().length, kept()[0], kept().at(-1)]).toEqual([MOST_RECORDS, 3, MOST_RECORDS + 2]);
    log.add(lines(1, MOST_RECORDS + 7));
    expect([kept().length, kept()[0]]).toEqual([MOST_RECORDS, 8]);
  });

  it('is held back while it is paused, and says how much', () => {
    const { log, shown, kept } = setUp();
    log.add([line(1)]);
    log.pause(true);
    log.add([line(2)]);
    log.add([line(3)]);
    expect([shown(), kept(), log.held.value]).toEqual([[1], [1, 2, 3], 2]);
    log.pause(false);
    expect([shown(), log.held.value]).toEqual([[1, 2, 3], 0]);
    log.pause(true);
    log.add([line(4)]);
    log.clear();
    expect([shown(), log.held.value]).toEqual([[], 0]);
    log.pause(false);
    expect(shown()).toEqual([]);
  });

  it('is shown again in full where the worker that showed it has ended', () => {
    const { log, shown, dies } = setUp();
    log.add([line(1), line(2)]);
    dies();
    log.add([line(3)]);
    log.add([line(4)]);
    expect(shown()).toEqual([1, 2, 3, 4]);
  });
});
