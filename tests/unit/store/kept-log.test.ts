import { signal } from '@preact/signals-core';
import { describe, expect, it } from 'vitest';
import type { LogLine } from '../../../src/bus/index.ts';
import { BusLog } from '../../../src/store/bus-log.ts';
import { KeptLog, MOST_KEPT, type TraceState } from '../../../src/store/index.ts';

const line = (number: number, more: Partial<LogLine> = {}): LogLine => ({
  time: 1_764_477_115_000 + number,
  direction: 'sent',
  transport: 'rtu',
  kind: 'request',
  hex: '1103006B00037687',
  ...more,
});
const lines = (count: number, more?: Partial<LogLine>) => Array.from({ length: count }, (_, at) => line(at + 1, more));
const log = () =>
  new BusLog({ state: signal<TraceState>({ kind: 'empty' }), append: () => undefined, clear: () => undefined });

/** The storage of a tab, which takes so many characters. */
class Tab {
  text: string | null = null;
  readonly most: number;
  constructor(most = 5_000_000) {
    this.most = most;
  }
  readonly texts = () => ({
    getItem: () => this.text,
    setItem: (_key: string, text: string) => {
      if (text.length > this.most) throw new Error('full');
      this.text = text;
    },
    removeItem: () => undefined,
  });

  /** Loads the page again: the log that is there then. */
  load(): { readonly log: BusLog; readonly kept: KeptLog } {
    const loaded = log();
    return { log: loaded, kept: new KeptLog(loaded, this.texts) };
  }
}

describe('a log when the page is loaded again', () => {
  it('is as it was, with what the session knew', () => {
    const tab = new Tab();
    const all = [
      line(1, { verdict: 'doubtful', time: 1_764_477_115_123.456 }),
      line(2, { direction: 'received', kind: 'reply', hex: '110306022B00000064C8BA' }),
      line(3, { direction: 'received', kind: 'late', transport: 'ascii' }),
      line(4, { direction: 'received', kind: 'heard' }),
    ];
    const before = tab.load();
    before.log.add(all);
    before.kept.keep();
    const { log } = tab.load();
    expect(log.records).toEqual(before.log.records);
    expect(log.records.map(({ time, side, transport, known }) => [time, side, transport, known])).toEqual([
      [1_764_477_115_123_456, 'request', 'rtu', { outcome: 'doubtful' }],
      [1_764_477_115_002_000, 'response', 'rtu', undefined],
      [1_764_477_115_003_000, 'response', 'ascii', { beside: 'late' }],
      [1_764_477_115_004_000, undefined, 'rtu', undefined],
    ]);
    expect([log.restored.value, log.cleared.value]).toEqual([4, 0]);
    log.add(lines(1));
    expect(log.records.length).toBe(5);
    log.clear();
    expect(log.restored.value).toBe(0);
  });

  it('is the last 20,000 records of a longer one', () => {
    const tab = new Tab();
    const { log, kept } = tab.load();
    log.add(lines(MOST_KEPT + 5));
    kept.keep();
    const again = tab.load().log.records;
    expect([again.length, again.at(-1)?.time]).toEqual([MOST_KEPT, log.records.at(-1)?.time]);
  });

  it('is shorter where frames are long, or the browser takes less', () => {
    const long = new Tab();
    const { log, kept } = long.load();
    log.add(lines(MOST_KEPT, { hex: '00'.repeat(256), verdict: 'doubtful' }));
    kept.keep();
    const count = long.load().log.records.length;
    expect(long.text?.length).toBeLessThanOrEqual(4_000_000);
    expect(count).toBeGreaterThan(5000);
    const small = new Tab(100_000);
    const other = small.load();
    other.log.add(lines(5000));
    other.kept.keep();
    expect(small.load().log.records.length).toBeGreaterThan(300);
  });

  it('is nothing after it was cleared, or where the browser keeps nothing', () => {
    const tab = new Tab();
    const { log: first, kept } = tab.load();
    first.add(lines(3));
    kept.keep();
    first.clear();
    kept.keep();
    expect(tab.load().log.records).toEqual([]);
    const refusing = log();
    const nowhere = new KeptLog(refusing, () => {
      throw new Error('refused');
    });
    refusing.add(lines(1));
    nowhere.keep();
    expect(refusing.records).toHaveLength(1);
    tab.text = '{"format":"something else"}';
    expect(tab.load().log.records).toEqual([]);
  });

  it('is that of an older version of the page, too', () => {
    const tab = new Tab();
    tab.text = JSON.stringify({ format: 'framewright log', version: 1, lines: [line(1, { verdict: 'silent' })] });
    expect(tab.load().log.records).toMatchObject([{ time: 1_764_477_115_001_000, known: { outcome: 'silent' } }]);
  });
});
