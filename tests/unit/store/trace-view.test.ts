import { describe, expect, it } from 'vitest';
import type { TraceState } from '../../../src/store/index.ts';
import { trace as words } from '../../../src/words/en/trace.ts';
import { type TraceAnswer, TraceDesk, type TraceRow } from '../../../src/workbench/index.ts';
import { playedTrace } from './played-trace.ts';

// AP 6.3: registers 108 to 110 are asked for and answered; a refusal, a reply with a bit changed, two requests without a reply.
const ASK = '11 03 00 6B 00 03 76 87';
const LOG = [
  `10:31:12.300 Tx ${ASK}`,
  '10:31:12.316 Rx 11 03 06 02 2B 00 00 00 64 C8 BA',
  '10:31:13.300 Tx 11 03 00 00 00 04 46 99',
  '10:31:13.310 Rx 11 83 02 C1 34',
  `10:31:14.300 Tx ${ASK}`,
  '10:31:14.320 Rx 11 03 06 02 2B 00 01 00 64 C8 BA',
  '10:31:15.300 Tx 06 03 02 A9 00 01 54 25',
  '10:31:17.300 Tx 06 03 02 A9 00 01 54 25',
].join('\n');

function opened(text = LOG) {
  const all = playedTrace();
  all.view.openText(text);
  all.work();
  return all;
}

const kinds = (rows: readonly (TraceRow | undefined)[]) =>
  rows.map((row) => row?.faults.map(({ kind }) => kind).join());

describe('a trace', () => {
  it('says how far the reading is, and then what is in the text', () => {
    const { view, work } = playedTrace();
    const states: TraceState['kind'][] = [];
    view.state.subscribe(({ kind }) => states.push(kind));
    view.openText(LOG);
    expect(view.state.value).toEqual({ kind: 'opening', name: undefined, percent: 0 });
    work();
    expect(states.at(-1)).toBe('open');
    expect(view.state.value).toMatchObject({ kind: 'open', format: 'text' });
    expect(view.summary.value).toMatchObject({
      frames: 8,
      exchanges: 5,
      units: [6, 17],
      faults: { exception: 1, checksum: 1, 'no-reply': 2 },
      replyTime: { median: 16_000, maximum: 20_000 },
    });
  });

  it('has a row for each frame, with what is wrong with it', () => {
    const { rows } = opened();
    const all = rows();
    expect(kinds(all)).toEqual(['', '', '', 'exception', '', 'checksum', 'no-reply', 'no-reply']);
    expect(all[1]).toMatchObject({
      side: 'response',
      unit: 17,
      functionCode: 3,
      after: 16_000,
      gap: 16_000,
      length: 11,
    });
    expect(all[1]?.saying).toEqual({
      table: 'holding-register',
      first: 107,
      count: 3,
      names: [undefined, undefined],
      values: [
        { address: 107, value: 0x22b },
        { address: 108, value: 0 },
        { address: 109, value: 100 },
      ],
      more: 0,
    });
    expect(all[3]).toMatchObject({ exception: 2, functionCode: 3 });
  });

  it('has a row for each exchange, with its reply', () => {
    const { view, rows, work } = opened();
    view.setUnit('exchange');
    work();
    const all = rows();
    expect(kinds(all)).toEqual(['', 'exception', 'checksum', 'no-reply', 'no-reply']);
    expect(all[0]?.reply).toMatchObject({ index: 1, side: 'response' });
    expect(all[1]).toMatchObject({ index: 2, exception: 2, after: 10_000 });
  });

  it('is filtered, and keeps the row that was chosen', () => {
    const { view, rows, work } = opened();
    view.choose(6);
    work();
    view.setFilter('no-reply');
    expect(view.filtering.value).toBe(true);
    work();
    expect(kinds(rows())).toEqual(['no-reply', 'no-reply']);
    expect(view.chosen.value).toBe(0);
    view.setFilter('unit:17');
    work();
    expect(view.rowsKept.value).toBe(6);
    expect(view.chosen.value).toBe(-1);
  });

  it('leaves the list as it is while the filter has a mistake', () => {
    const { view, work } = opened();
    view.setFilter('unit:17');
    work();
    view.setFilter('unit:17 unti:3');
    work();
    expect(view.read.value).toEqual({
      kind: 'mistakes',
      mistakes: [{ code: 'not-known', got: 'unti', meant: 'unit', from: 8, to: 14 }],
    });
    expect(view.rowsKept.value).toBe(6);
    expect([view.filter.value, view.applied.value]).toEqual(['unit:17 unti:3', 'unit:17']);
    view.setUnit('exchange');
    work();
    expect([view.rowsKept.value, view.applied.value]).toEqual([3, 'unit:17']);
  });

  it('makes its rows exchanges while the filter has a mistake', () => {
    const { view, work } = opened();
    view.setFilter('unit:17');
    view.setFilter('unti:3');
    view.setUnit('exchange');
    work();
    expect([view.filter.value, view.rowsKept.value]).toEqual(['unti:3', 3]);
  });

  it('is restored with a filter and the frame that was chosen, or says that the list lacks it', () => {
    const { view, work, shown } = opened();
    view.restore('exception', 'exchange', 3);
    work();
    work();
    expect([view.rowsKept.value, view.chosen.value, view.record.value]).toEqual([1, 0, 2]);
    expect(shown).toHaveLength(1);
    view.restore('exception', 'frame', 5);
    work();
    work();
    expect([view.chosen.value, view.missing.value]).toEqual([-1, 5]);
    view.restore('', 'exchange', 99);
    work();
    expect(view.missing.value).toBe(99);
    view.nextFault();
    work();
    work();
    expect([view.record.value, view.missing.value]).toEqual([2, undefined]);
    view.restore('', 'frame', undefined);
    work();
    work();
    expect([view.chosen.value, view.record.value, shown.length]).toEqual([-1, undefined, 2]);
  });

  it('leads from fault to fault, and shows the frame with the other of its exchange', () => {
    const { view, work, shown } = opened();
    const places = [];
    for (let key = 0; key < 5; key++) {
      view.nextFault();
      work();
      places.push(view.chosen.value);
    }
    expect(places).toEqual([3, 5, 6, 7, 7]);
    view.previousFault();
    work();
    expect(view.chosen.value).toBe(6);
    expect(shown).toHaveLength(5);
    expect(shown[0]).toMatchObject({ how: 'step', frame: { index: 3, side: 'response', transport: 'rtu' } });
    expect([...(shown[0]?.frame.request ?? [])].slice(0, 2)).toEqual([0x11, 3]);
  });

  it('goes as many faults on as keys were pressed, also before the first has come', () => {
    const { view, work } = opened();
    for (let key = 0; key < 3; key++) view.nextFault();
    view.previousFault();
    work();
    expect(view.chosen.value).toBe(5);
    view.nextFault();
    view.setFilter('no-reply');
    view.nextFault();
    work();
    expect([view.rowsKept.value, view.chosen.value]).toEqual([2, 0]);
  });

  it('marks where the faults are', () => {
    const { view } = opened();
    expect(view.marks.value).toEqual([
      { row: 3, severity: 'warning' },
      { row: 5, severity: 'error' },
      { row: 6, severity: 'error' },
      { row: 7, severity: 'error' },
    ]);
  });

  it('grows, and looks again at rows whose reply comes later', () => {
    const { view, work, rows } = playedTrace();
    const hex = (text: string) => Uint8Array.from(text.split(' '), (pair) => Number.parseInt(pair, 16));
    view.append([{ bytes: hex(ASK), time: 0, side: 'request' }]);
    work();
    expect(view.state.value.kind).toBe('open');
    expect(rows()).toHaveLength(1);
    view.append([{ bytes: hex('11 83 02 C1 34'), time: 9000, side: 'response' }]);
    work();
    expect(kinds(rows())).toEqual(['', 'exception']);
    view.setFilter('no-reply');
    work();
    expect(view.rowsKept.value).toBe(0);
    view.append([{ bytes: hex(ASK), time: 1_000_000, side: 'request' }]);
    work();
    view.append([{ bytes: hex(ASK), time: 3_000_000, side: 'request' }]);
    work();
    expect(view.rowsKept.value).toBe(1);
  });

  it('asks for rows by windows, and once for each', () => {
    const { view, workers, work } = opened(`${LOG}\n`.repeat(100));
    expect(view.row(500)).toBeUndefined();
    expect(view.row(501)).toBeUndefined();
    const asked = workers[0]?.tasks.filter(({ kind }) => kind === 'rows');
    expect(asked).toEqual([{ kind: 'rows', from: 480, to: 512 }]);
    work();
    expect(view.row(500)?.index).toBe(500);
    expect(view.row(800)).toBeUndefined();
  });

  it('forgets what it was when another is opened, and says when reading was given up', () => {
    const { view, workers, work } = opened();
    view.setFilter('exception');
    view.open({ name: 'two.log', text: ASK });
    expect(view.filter.value).toBe('');
    expect(view.rowsKept.value).toBe(0);
    expect(view.state.value).toMatchObject({ kind: 'opening', name: 'two.log' });
    view.cancel();
    expect(view.state.value).toEqual({ kind: 'empty' });
    work();
    expect(view.state.value).toEqual({ kind: 'empty' });
    expect(workers[0]?.alive).toBe(false);
    view.openText(LOG);
    work();
    expect(view.rowsKept.value).toBe(8);
  });

  it('says that its worker has ended', () => {
    const { view, workers } = opened();
    workers[0]?.end();
    expect(view.state.value).toEqual({ kind: 'failed', name: undefined, code: 'died' });
    expect(view.rowsKept.value).toBe(0);
  });
});

describe('a filter of a long trace', () => {
  const long = () => {
    const told: Extract<TraceAnswer, { kind: 'list' }>[] = [];
    const later: (() => void)[] = [];
    const desk = new TraceDesk(
      (answer) => answer.kind === 'list' && told.push(answer),
      (act) => later.push(act),
    );
    let said = 0;
    // The same bytes would be asked for once: each frame has another address.
    desk.says = ({ hex }) => {
      said++;
      return Number.parseInt(hex.slice(4, 8), 16) % 1000 === 7 ? 'seven' : 'other';
    };
    const bytesAt = (time: number) => Uint8Array.from([6, 3, time >> 8, time & 0xff, 0, 1, 0x54, 0x25]);
    desk.take({
      kind: 'append',
      records: Array.from({ length: 20_000 }, (_, time) => ({ bytes: bytesAt(time), time })),
      most: undefined,
    });
    while (later.length > 0) later.shift()?.();
    const slice = () => later.shift()?.();
    const rest = () => {
      while (later.length > 0) slice();
    };
    return { desk, told, later, slice, rest, said: () => said };
  };

  it('says how far it is, goes on behind records that are added, and gives way to another text', () => {
    const { desk, told, slice, rest, said } = long();
    told.length = 0;
    desk.take({ kind: 'filter', text: 'text:seven', by: 'frame', list: 1 });
    slice();
    const first = told.at(-1);
    expect(first).toMatchObject({ list: 1, done: false, marks: [] });
    expect(first?.percent).toBeGreaterThan(0);
    expect(first?.percent).toBeLessThan(50);
    const before = said();
    desk.take({ kind: 'filter', text: 'text:other', by: 'frame', list: 2 });
    rest();
    expect(told.filter(({ list }) => list === 1)).toHaveLength(2);
    expect(told.at(-1)).toMatchObject({ list: 2, count: 19_980, done: true, percent: 100 });
    // Each row once, and none for the text that was given up.
    expect(said() - before).toBe(20_000);
    expect(told.length).toBeLessThan(110);
    const settled = said();
    desk.take({
      kind: 'append',
      records: [{ bytes: Uint8Array.from([1, 3, 0, 0, 0, 1, 0x84, 0x0a]), time: 20_000 }],
      most: undefined,
    });
    rest();
    expect(told.at(-1)).toMatchObject({ count: 19_981, done: true });
    expect(said() - settled).toBeLessThan(300);
  });
});

/** A request that damaged bytes answer, a line of words with digits, and an exchange (AP 6.3 as RTU). */
const PIECES = [
  `10:31:12.300 Tx ${ASK}`,
  '10:31:12.316 Rx 21 00 00',
  `10:31:14.300 Tx ${ASK}`,
  '10:31:14.316 Rx 11 03 06 02 2B 00 00 00 64 C8 BA',
].join('\n');

describe('the silences of a line', () => {
  // 8 characters of 11 bits at 9600 baud are 9.2 ms, and t3.5 is 4 ms: a request that follows a reply of 7 within 12 ms is too early.
  const FAST = Array.from({ length: 4 }, (_, n) => [
    `10:31:0${n}.000 Tx 06 03 02 A9 00 01 54 25`,
    `10:31:0${n}.020 Rx 06 03 02 10 00 00 44`,
    `10:31:0${n}.030 Tx 06 03 02 A9 00 01 54 25`,
    `10:31:0${n}.050 Rx 06 03 02 10 00 00 44`,
  ])
    .flat()
    .join('\n');

  it('are judged by the speed that somebody gives, in rows, summary, causes and statistics, and no more without it', () => {
    const { view, work, rows } = opened(FAST);
    const seen = () => ({
      faults: view.summary.value?.faults.timing,
      rows: kinds(rows()).flatMap((kind, row) => (kind === 'timing' ? [row] : [])),
      causes: view.causes.value.map(({ code }) => code),
      unit: view.tabs.tallies.value?.rows[0]?.faults.timing,
    });
    const none = { faults: 0, rows: [], causes: [], unit: 0 };
    view.tabs.want({ kind: 'statistics', by: 'unit' });
    work();
    expect(seen()).toEqual(none);
    view.setLine({ baud: 9600, bits: 11 });
    work();
    expect(seen()).toEqual({ faults: 4, rows: [2, 6, 10, 14], causes: ['polled-too-fast'], unit: 4 });
    expect(view.causes.value[0]).toMatchObject({ explained: 4, all: 4 });
    // At 115200 baud t3.5 is 1.75 ms (SL 2.5.1.1).
    view.setLine({ baud: 115_200, bits: 11 });
    work();
    expect(seen()).toEqual(none);
    view.setLine({ baud: 9600, bits: 11 });
    view.setLine(undefined);
    work();
    expect(seen()).toEqual(none);
    expect(view.rowsKept.value).toBe(16);
  });

  it('are not judged in the log that is opened next', () => {
    const { view, work } = opened(FAST);
    view.setLine({ baud: 9600, bits: 11 });
    work();
    view.openText(FAST);
    work();
    expect([view.line.value, view.summary.value?.faults.timing]).toEqual([undefined, 0]);
  });
});

describe('what is in no frame', () => {
  it('has a row where it stands, and is neither a frame nor an exchange nor of a unit', () => {
    const { view, rows, work } = opened(PIECES);
    expect(view.summary.value).toMatchObject({ frames: 3, exchanges: 2, units: [17] });
    expect([view.pieces.value, view.rowsKept.value, view.piecesKept.value]).toEqual([1, 4, 1]);
    const all = rows();
    expect(kinds(all)).toEqual(['no-reply', 'no-frame', '', '']);
    expect(all[1]).toMatchObject({
      hex: '210000',
      time: 16_000,
      known: { beside: 'noise', why: 'no-frame', line: 2 },
      place: { kind: 'text', from: 56, to: 64 },
    });
    expect(view.problems.value.count).toBe(0);
    for (const filter of ['unit:0-255', 'unit>0', 'unit<300', 'fc:0-255', 'addr:0-65535', 'value>=0']) {
      view.setFilter(filter);
      work();
      expect([filter, view.piecesKept.value]).toEqual([filter, 0]);
    }
    view.setFilter('');
    view.setUnit('exchange');
    work();
    expect(kinds(rows())).toEqual(['no-reply', 'no-frame', '']);
  });

  it('is found by the keys for faults, by its mark and by its own filter, not by that for broken frames', () => {
    const { view, work, shown } = opened(PIECES);
    expect(view.marks.value).toEqual([
      { row: 0, severity: 'error' },
      { row: 1, severity: 'error' },
    ]);
    view.nextFault();
    view.nextFault();
    work();
    work();
    expect(view.chosen.value).toBe(1);
    expect(shown.at(-1)?.frame.bytes).toEqual(Uint8Array.of(0x21, 0, 0));
    for (const [filter, count] of [
      ['no-frame', 1],
      ['broken', 0],
      ['fault', 2],
      ['-no-frame', 3],
      ['text:"21 00"', 1],
    ] as const) {
      view.setFilter(filter);
      work();
      expect([filter, view.rowsKept.value]).toEqual([filter, count]);
    }
  });

  it('is counted by no tally, and offered to complete the filter', () => {
    const { view, work } = opened(PIECES);
    view.occurring.want();
    work();
    expect(view.occurring.known.value).toMatchObject({
      units: [{ value: 17, count: 2 }],
      faults: [
        { word: 'no-reply', count: 1 },
        { word: 'no-frame', count: 1 },
      ],
    });
  });

  it('is the same for the noise that a bus hears', () => {
    const { view, work, rows } = playedTrace();
    view.append([{ bytes: Uint8Array.of(0xff, 0), time: 5, known: { beside: 'noise' } }]);
    work();
    expect(view.summary.value).toMatchObject({ frames: 0, exchanges: 0 });
    expect([view.pieces.value, kinds(rows())]).toEqual([1, ['no-frame']]);
  });
});

describe('what is said of a chosen row beside its bytes', () => {
  const about = (text: string, row: number) => {
    const { view, work } = opened(text);
    view.choose(row);
    work();
    return view.about.value && words.about(view.about.value);
  };

  it('is that no reply came, within which time, and what came in its place', () => {
    expect(about(LOG, 6)).toBe('No reply within 1,000 ms. 2,000 ms later: Read 1 holding register from 681 (40682).');
    expect(about(LOG, 7)).toBe('No reply: nothing follows this request in the log.');
    expect(about(PIECES, 0)).toBe('No reply before what comes 16 ms later: 3 bytes in line 2, in no frame.');
    expect(about(PIECES.replaceAll(/^.{13}/gm, ''), 0)).toBe(
      'No reply. What comes next: 3 bytes in line 2, in no frame.',
    );
  });

  it('is the same on the bus, which has its own time-out', () => {
    const { view, work } = playedTrace();
    const bytes = Uint8Array.of(0x11, 3, 0, 0x6b, 0, 3, 0x76, 0x87);
    view.append([{ bytes, time: 5, side: 'request', known: { outcome: 'silent' } }]);
    work();
    view.choose(0);
    work();
    expect(view.about.value && words.about(view.about.value)).toBe('No reply within the time-out.');
  });

  it('is nothing where the bytes say all', () => {
    for (const row of [0, 1, 3, 5]) expect(about(LOG, row)).toBeUndefined();
  });

  it('is why it is in no frame', () => {
    expect(about(PIECES, 1)).toBe('In no frame: 3 bytes in line 2.');
    const words = `Tx ${ASK}\nRx 11 03 06 02 2B 0G 1G`;
    expect(about(words, 2)).toBe('In no frame: “0G 1G” in line 2, not a byte.');
  });
});

describe('the clock of the filter', () => {
  const filtered = (source: string, filter: string) => {
    const { view, work } = opened(source);
    view.setFilter(filter);
    work();
    return view.rowsKept.value;
  };

  it('is the one that a text prints', () => {
    expect(
      ['from:10:31:14', 'from:10:31:13.310 to:10:31:14.300', 'to:10:31', 'from:2'].map((text) => filtered(LOG, text)),
    ).toEqual([4, 2, 0, 4]);
    const dated = LOG.replaceAll(/^/gm, '2026-11-30 ');
    expect(
      ['from:10:31:14', 'from:2026-11-30T10:31:14', 'from:2026-12-01'].map((text) => filtered(dated, text)),
    ).toEqual([4, 4, 0]);
  });

  it('is that of the reader for times since 1970, and counts from 0 for times without a date', () => {
    const table = (times: readonly string[]) =>
      `time,side,bytes\n${times.map((time) => `${time},request,${ASK}\n`).join('')}`;
    const dated = table(['2026-11-30T09:30:59Z', '2026-11-30T09:31:00Z', '2026-11-30T09:32:00Z']);
    expect(filtered(dated, 'from:10:31')).toBe(2);
    expect(filtered(dated, 'from:2026-11-30T10:31 to:2026-11-30T10:31:30')).toBe(1);
    const { view } = opened(dated);
    expect(view.state.value).toMatchObject({ format: 'csv', clock: undefined });
    const relative = table(['0.000000', '59.500000', '61.000000']);
    expect(filtered(relative, 'from:0:01')).toBe(1);
    expect(opened(relative).view.state.value).toMatchObject({ clock: { shows: 'count', shift: 0 } });
  });
});

describe('what the filter is completed with', () => {
  it('is counted when somebody begins to type, and again when the trace has grown', () => {
    const { view, work } = opened();
    view.occurring.want();
    view.occurring.want();
    work();
    expect(view.occurring.known.value).toMatchObject({
      units: [
        { value: 6, count: 2 },
        { value: 17, count: 3 },
      ],
      exceptions: [{ value: 2, count: 1 }],
      faults: [
        { word: 'crc', count: 1 },
        { word: 'exception', count: 1 },
        { word: 'no-reply', count: 2 },
      ],
      times: ['10:31:12.300000', '10:31:17.300000'],
    });
    view.append([{ bytes: Uint8Array.from([1, 3, 0, 0, 0, 1, 0x84, 0x0a]) }]);
    work();
    view.occurring.want();
    work();
    expect(view.occurring.known.value.units.map(({ value }) => value)).toEqual([1, 6, 17]);
  });
});

describe('a file of the trace', () => {
  const wanted = { wanted: { format: 'csv', replaced: {} }, ofFiltered: true, source: '' } as const;

  it('is made of what the filter keeps', async () => {
    const { view, work } = opened();
    view.setUnit('exchange');
    view.setFilter('exception');
    const making = view.exports.make(wanted);
    expect(view.exports.percent.value).toBe(0);
    work();
    const made = await making;
    if (typeof made === 'string') throw new TypeError(made);
    expect(made.frames).toBe(2);
    expect(
      made.parts
        .join('')
        .split('\r\n')
        .map((line) => line.split(',')[0]),
    ).toEqual(['number', '3', '4', '']);
    expect(view.exports.percent.value).toBeUndefined();
  });

  it('is given up by hand, for another file, and with the trace', async () => {
    const { view, work, workers } = opened();
    const first = view.exports.make(wanted);
    const second = view.exports.make({ ...wanted, ofFiltered: false });
    expect(await first).toBe('given-up');
    work();
    expect(await second).toMatchObject({ frames: 8 });
    const third = view.exports.make(wanted);
    view.exports.cancel();
    expect(await third).toBe('given-up');
    const fourth = view.exports.make(wanted);
    view.openText(LOG);
    expect(await fourth).toBe('given-up');
    const fifth = view.exports.make(wanted);
    workers.at(-1)?.end();
    expect(await fifth).toBe('given-up');
  });

  it('cannot be made without its words', async () => {
    const { view, work } = opened();
    const making = view.exports.make({ ...wanted, wanted: { format: 'report', replaced: {} } });
    work();
    expect(await making).toBe('failed');
  });
});

describe('the tabs beside the list', () => {
  it('show what the one that is open asks for, and follow the filter', () => {
    const { view, work } = opened();
    view.tabs.want({ kind: 'timeline', columns: 100 });
    expect(view.tabs.busy.value).toBe(true);
    work();
    expect(view.tabs.timeline.value?.bins.map(({ maximum }) => maximum)).toEqual([
      16_000,
      10_000,
      20_000,
      undefined,
      undefined,
    ]);
    view.setFilter('exception');
    work();
    work();
    expect(view.tabs.timeline.value?.bins).toHaveLength(1);
    expect(view.tabs.busy.value).toBe(false);
  });

  it('count by what is chosen', () => {
    const { view, work } = opened();
    view.tabs.want({ kind: 'statistics', by: 'unit' });
    work();
    expect(view.tabs.tallies.value).toMatchObject({
      by: 'unit',
      rows: [{ unit: 6, exchanges: 2 }, { unit: 17 }],
      count: 2,
    });
    view.tabs.want({ kind: 'statistics', by: 'unit', sort: { by: 'unit', down: true } });
    work();
    expect(view.tabs.tallies.value?.rows.map(({ unit }) => unit)).toEqual([17, 6]);
    view.tabs.want({ kind: 'values' });
    work();
    expect(view.tabs.known.value?.count).toBe(3);
  });

  it('have the first of very many, and how many there are', () => {
    const { view, work } = playedTrace();
    const asked = (address: number) => Uint8Array.of(0, 1, 0, 0, 0, 6, 1, 3, address >> 8, address & 0xff, 0, 1);
    view.append(
      Array.from({ length: 2001 }, (_, address) => ({ bytes: asked(address), transport: 'tcp', side: 'request' })),
    );
    view.tabs.want({ kind: 'statistics', by: 'address', sort: { by: 'address', down: true } });
    work();
    const { rows = [], count } = view.tabs.tallies.value ?? {};
    expect([rows.length, count, rows[0]?.address]).toEqual([2000, 2001, 2000]);
  });

  it('count again what has grown, when the window says', () => {
    const { view, work, workers } = opened();
    view.tabs.want({ kind: 'statistics', by: 'unit' });
    work();
    view.append([{ bytes: Uint8Array.of(0x06, 0x83, 0x02, 0xd0, 0x30) }]);
    work();
    expect(view.tabs.tallies.value?.rows[0]).toMatchObject({ unit: 6, exchanges: 2, replies: 0 });
    expect(workers.at(-1)?.tasks).toEqual([]);
    view.tabs.refresh();
    work();
    expect(view.tabs.tallies.value?.rows[0]).toMatchObject({ unit: 6, exchanges: 2, replies: 1 });
    view.tabs.refresh();
    expect(workers.at(-1)?.tasks).toEqual([]);
  });

  it('forget what they had with the trace', () => {
    const { view, work } = opened();
    view.tabs.want({ kind: 'values' });
    work();
    view.openText('10:31:12.300 Tx 11 03 00 6B 00 03 76 87');
    expect(view.tabs.known.value).toBeUndefined();
    work();
    work();
    expect(view.tabs.known.value?.count).toBe(0);
  });
});
