import { describe, expect, it } from 'vitest';
import type { LogLine } from '../../../src/bus/index.ts';
import { BusLog } from '../../../src/store/bus-log.ts';
import { KeptLog, MOST_KEPT } from '../../../src/store/index.ts';

const line = (number: number, more: Partial<LogLine> = {}): LogLine => ({
  number,
  time: 1_764_477_115_123.456,
  direction: 'sent',
  transport: 'rtu',
  kind: 'request',
  hex: '1103006B00037687',
  ...more,
});
const lines = (count: number, more?: Partial<LogLine>) => Array.from({ length: count }, (_, at) => line(at + 1, more));

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
    const log = new BusLog(() => () => undefined);
    return { log, kept: new KeptLog(log, this.texts) };
  }
}

describe('a log when the page is loaded again', () => {
  it('is as it was, with what the session knew', () => {
    const tab = new Tab();
    const all = [
      line(1, { verdict: 'doubtful', duration: 4.25 }),
      line(2, { direction: 'received', kind: 'reply', hex: '110306022B00000064C8BA', answers: 1 }),
      line(3, { direction: 'received', kind: 'late' }),
    ];
    const before = tab.load();
    before.log.add(all);
    before.kept.keep();
    const { log } = tab.load();
    expect(log.lines).toEqual(all);
    expect([log.restored.value, log.cleared.value]).toEqual([3, undefined]);
    log.clear();
    expect(log.restored.value).toBe(0);
  });

  it('goes on behind what was kept, and a reply answers the request of its own session', () => {
    const tab = new Tab();
    const before = tab.load();
    before.log.add(lines(2));
    before.kept.keep();
    const { log } = tab.load();
    log.add([line(1), line(2, { answers: 1 })]);
    log.add([line(3), line(4, { answers: 3 })]);
    expect(log.lines.map(({ number, answers }) => [number, answers])).toEqual([
      [1, undefined],
      [2, undefined],
      [3, undefined],
      [4, 3],
      [5, undefined],
      [6, 5],
    ]);
    // The session was already at its fourth line, whose request is not in the log any more.
    log.open(lines(6));
    log.add([line(5, { answers: 4 })]);
    expect(log.lines.at(-1)).toEqual(line(7));
  });

  it('is the last 20,000 lines of a longer one', () => {
    const tab = new Tab();
    const { log, kept } = tab.load();
    log.add(lines(MOST_KEPT + 5));
    kept.keep();
    const again = tab.load().log.lines;
    expect([again.length, again[0]?.number, again.at(-1)?.number]).toEqual([MOST_KEPT, 1, MOST_KEPT]);
  });

  it('is shorter where frames are long, or the browser takes less', () => {
    const long = new Tab();
    const { log, kept } = long.load();
    log.add(lines(MOST_KEPT, { hex: '00'.repeat(256) }));
    kept.keep();
    const count = long.load().log.lines.length;
    expect(long.text?.length).toBeLessThanOrEqual(4_000_000);
    expect(count).toBeGreaterThan(5000);
    const small = new Tab(100_000);
    const other = small.load();
    other.log.add(lines(5000));
    other.kept.keep();
    expect(small.load().log.lines.length).toBeGreaterThan(300);
  });

  it('is nothing after it was cleared, or where the browser keeps nothing', () => {
    const tab = new Tab();
    const { log, kept } = tab.load();
    log.add(lines(3));
    kept.keep();
    log.clear();
    kept.keep();
    expect(tab.load().log.lines).toEqual([]);
    const refusing = new BusLog(() => () => undefined);
    const nowhere = new KeptLog(refusing, () => {
      throw new Error('refused');
    });
    refusing.add(lines(1));
    nowhere.keep();
    expect(refusing.lines).toHaveLength(1);
    tab.text = '{"format":"something else"}';
    expect(tab.load().log.lines).toEqual([]);
  });
});
