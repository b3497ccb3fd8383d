import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { causesOf, TraceStatistics, traceOf } from '../../../../src/trace/index.ts';
import {
  completions,
  Describer,
  filterKnown,
  filterText,
  momentIn,
  parseFilter,
  type ReadFilter,
} from '../../../../src/workbench/index.ts';
import { anyCharacter } from '../../any-character.ts';
import { hex } from '../../captures/wire.ts';

const SECOND = 1_000_000;
const FIRST = Date.UTC(2026, 10, 30, 10, 30) * 1000;

// AP 6.3 and AP 6.6 print these as PDUs; the frames of exception 02 and of function 23 follow AP 7 and AP 6.17.
const FRAMES: readonly (readonly [at: number, side: 'request' | 'response', bytes: string])[] = [
  [0, 'request', '0001 0000 0006 01 03 006B 0003'],
  [0.004, 'response', '0001 0000 0009 01 03 06 022B 0000 0064'],
  [60, 'request', '0002 0000 0006 06 06 0001 0003'],
  [60.3, 'response', '0002 0000 0006 06 06 0001 0003'],
  [120, 'request', '0003 0000 0006 06 03 0000 000A'],
  [120.01, 'response', '0003 0000 0003 06 83 02'],
  [900, 'request', '0004 0000 000D 11 17 0003 0001 000E 0001 02 00FF'],
  [900.02, 'response', '0004 0000 0005 11 17 02 00FE'],
  [960, 'request', '0005 0000 0006 11 01 0013 0013'],
];
const trace = traceOf(
  FRAMES.map(([at, side, bytes]) => ({
    bytes: hex(bytes),
    side,
    time: FIRST + at * SECOND,
    transport: 'tcp',
    place: { kind: 'text', from: 0, to: 0 },
  })),
);

function read(text: string): ReadFilter {
  const filter = parseFilter(text);
  if (filter.kind !== 'filter') throw new Error(JSON.stringify(filter));
  return filter;
}

/** The frames that a filter keeps, counted from 0. */
function kept(text: string, by: 'frame' | 'exchange' = 'frame'): number[] {
  const { test } = read(text);
  const says = ({ index }: { index: number }) => `row ${index} = 30.0 Hz`;
  const describer = new Describer(trace, by, { causes: causesOf(trace), says });
  const size = by === 'frame' ? trace.size : trace.exchangeCount;
  return Array.from({ length: size }, (_, index) => index).filter((index) => test(describer.at(index)));
}

describe('a filter', () => {
  it.each([
    ['', [0, 1, 2, 3, 4, 5, 6, 7, 8]],
    ['unit:6', [2, 3, 4, 5]],
    ['unit:1,17', [0, 1, 6, 7, 8]],
    ['unit:1-6', [0, 1, 2, 3, 4, 5]],
    ['unit>6', [6, 7, 8]],
    ['UNIT:6 FC:3', [4, 5]],
    ['fc:3,16', [0, 1, 4, 5]],
    ['fc:0x17', [6, 7]],
    ['fc:23', [6, 7]],
    ['fc:0x83', [5]],
    ['exception', [5]],
    ['exception:02', [5]],
    ['exception:1-4', [5]],
    ['exception:1', []],
    ['no-reply', [8]],
    ['fault', [5, 8]],
    ['-fault unit:6', [2, 3, 4]],
    ['not unit:6 not unit:17', [0, 1]],
    ['- unit:6', [0, 1, 6, 7, 8]],
    ['addr:40108', [0, 1]],
    ['addr:108', [0, 1]],
    ['addr:110', []],
    ['addr:0x6D', [0, 1]],
    ['addr:40001-40010', [2, 3, 4, 5, 6, 7]],
    ['addr:00020', [8]],
    ['addr:19', [8]],
    ['addr:HR108', [0, 1]],
    ['addr:40004,00038', [4, 5, 6, 7, 8]],
    ['addr:40015', [6, 7]],
    ['value>100', [1, 6, 7]],
    ['value:255', [6]],
    ['value:99-100', [1]],
    ['value<1', [1]],
    ['slow>200', [3]],
    ['slow<=10', [1, 5]],
    ['late', []],
    ['"row 7"', [7]],
    ['text:"30.0 hz" unit:1', [0, 1]],
    ['text:"30 Hz" unit:1', [0, 1]],
    ['text:"3 Hz"', []],
    ['row unit:1', [0, 1]],
    ['nothing', []],
    ['from:10:31', [2, 3, 4, 5, 6, 7, 8]],
    ['from:10:31 to:10:32', [2, 3, 4]],
    ['to:10:30:00.004', [0, 1]],
    ['from:60.3 to:120s', [3, 4]],
    ['from:2026-11-30T10:45', [6, 7, 8]],
    ['to:2026-11-29', []],
    ['-from:10:31', [0, 1]],
  ])('%s', (text, frames) => {
    expect(kept(text)).toEqual(frames);
  });

  it('is asked of exchanges as well', () => {
    expect(kept('no-reply', 'exchange')).toEqual([4]);
    expect(kept('slow>200', 'exchange')).toEqual([1]);
    expect(kept('value:254', 'exchange')).toEqual([3]);
    expect(kept('from:10:45', 'exchange')).toEqual([3, 4]);
  });

  it.each([
    ['unti:6', [{ code: 'not-known', got: 'unti', meant: 'unit', from: 0, to: 6 }]],
    ['late -function:3', [{ code: 'not-known', got: 'function', meant: 'fc', from: 6, to: 16 }]],
    ['exeption:2', [{ code: 'not-known', got: 'exeption', meant: 'exception', from: 0, to: 10 }]],
    ['uniit:2', [{ code: 'not-known', got: 'uniit', meant: 'unit', from: 0, to: 7 }]],
    ['unix:2', [{ code: 'not-known', got: 'unix', meant: 'unit', from: 0, to: 6 }]],
    ['cause:echo,rain', [{ code: 'not-a-cause', got: 'rain', from: 0, to: 15 }]],
    ['foo:1', [{ code: 'not-known', got: 'foo', meant: undefined, from: 0, to: 5 }]],
    ['connection:6', [{ code: 'not-known', got: 'connection', meant: 'conn', from: 0, to: 12 }]],
    ['conn:"1', [{ code: 'quote-open', from: 0, to: 7 }]],
    ['unit:', [{ code: 'value-missing', term: 'unit', from: 0, to: 5 }]],
    ['unit', [{ code: 'value-missing', term: 'unit', from: 0, to: 4 }]],
    ['unit:6,', [{ code: 'not-a-number', got: '', from: 0, to: 7 }]],
    ['unit:a', [{ code: 'not-a-number', got: 'a', from: 0, to: 6 }]],
    ['unit:256', [{ code: 'out-of-range', got: 256, least: 0, most: 255, from: 0, to: 8 }]],
    ['unit:1.5', [{ code: 'not-a-number', got: '1.5', from: 0, to: 8 }]],
    ['unit:6-1', [{ code: 'range-reversed', got: '6-1', from: 0, to: 8 }]],
    ['addr:x', [{ code: 'not-an-address', got: 'x', from: 0, to: 6 }]],
    ['addr:40001-30002', [{ code: 'tables-differ', got: '40001-30002', from: 0, to: 16 }]],
    ['addr>5', [{ code: 'not-compared', term: 'addr', from: 0, to: 6 }]],
    ['from:25:00', [{ code: 'not-a-time', got: '25:00', from: 0, to: 10 }]],
    ['from:2026-02-29', [{ code: 'not-a-time', got: '2026-02-29', from: 0, to: 15 }]],
    ['cause:"', [{ code: 'not-a-cause', got: '"', from: 0, to: 7 }]],
    ['unit:1 text:"a b', [{ code: 'quote-open', from: 7, to: 16 }]],
    ['late not', [{ code: 'nothing-excluded', from: 5, to: 8 }]],
    [
      'unit:x  fc:y',
      [
        { code: 'not-a-number', got: 'x', from: 0, to: 6 },
        { code: 'not-a-number', got: 'y', from: 8, to: 12 },
      ],
    ],
  ])('says what is wrong: %s', (text, mistakes) => {
    expect(parseFilter(text)).toEqual({ kind: 'mistakes', mistakes });
  });

  it('is printed as it is read', () => {
    const text =
      'UNIT=6,1-3 fault checksum not fc:0x10 addr:108,0x9C41,HR108-40110 value>-5 from:10:31:05.5 30\\Hz "a \\" b" exception:02';
    expect(filterText(read(text).terms)).toBe(
      'unit:6,1-3 fault crc -fc:16 addr:108,0x9C41,40108-40110 value>-5 from:10:31:05.500000 text:"30\\\\Hz" text:"a \\" b" exception:2',
    );
  });
});

describe('any text', () => {
  const pieces = fc.constantFrom(
    ...'unit: fc: addr: value> value<= slow: from: to: text: conn: cause: exception late crc not - " \\ , 6 0x10 40001-40010 108 10:31 2026-11-30T1:02:03.5 12.5s -5 1e30 0.0000001 HR12 %QX13.3 \t 4x1'.split(
      ' ',
    ),
    ' ',
    '\n',
  );
  const texts = fc.oneof(
    fc.string({ unit: anyCharacter }),
    fc.array(pieces).map((all) => all.join('')),
    fc.array(pieces).map((all) => all.join(' ')),
  );

  it('is a filter that is printed to the same, or has mistakes within the text', () => {
    fc.assert(
      fc.property(texts, (text) => {
        const filter = parseFilter(text);
        if (filter.kind === 'mistakes') {
          for (const { from, to } of filter.mistakes) expect(0 <= from && from < to && to <= text.length).toBe(true);
          return;
        }
        expect(read(filterText(filter.terms)).terms).toEqual(filter.terms);
        kept(filterText(filter.terms));
      }),
    );
  });

  it('is completed within the text, by what keeps what stands before the caret', () => {
    const known = filterKnown(trace, new TraceStatistics(trace).take(), []);
    fc.assert(
      fc.property(texts, fc.nat(), (text, at) => {
        const caret = at % (text.length + 1);
        for (const { text: put, from, to } of completions(text, caret, known)) {
          expect(0 <= from && from <= caret && caret <= to && to <= text.length).toBe(true);
          expect(put.toLowerCase().startsWith(text.slice(from, caret).toLowerCase())).toBe(true);
        }
      }),
    );
  });
});

describe('completion', () => {
  const known = filterKnown(trace, new TraceStatistics(trace).take(), []);
  const texts = (text: string, caret = text.length) => completions(text, caret, known).map(({ text }) => text);

  it('offers terms, those faults first that occur', () => {
    expect(texts('').slice(0, 3)).toEqual(['exception', 'no-reply', 'fault']);
    expect(texts('f')).toEqual(['fault', 'fc:', 'from:']);
    expect(texts('unit:6 -ex')).toEqual(['exception', 'exception:']);
    expect(texts('unit:6 exception')).toEqual(['exception:']);
  });

  it('offers the values that occur', () => {
    expect(texts('unit:')).toEqual(['1', '6', '17']);
    expect(texts('unit:6,1')).toEqual(['17']);
    expect(texts('exception:')).toEqual(['02']);
    expect(texts('fc:')).toEqual(['1', '3', '6', '23']);
    expect(texts('addr:4000')).toEqual(['40001', '40002', '40004']);
    expect(completions('fc:3 unit:', 10, known)[1]).toEqual({
      text: '6',
      from: 10,
      to: 10,
      of: { kind: 'value', term: 'unit' },
      count: 2,
    });
  });

  it('offers nothing in a text', () => {
    expect(texts('text:"un')).toEqual([]);
    expect(texts('foo:')).toEqual([]);
  });
});

describe('names', () => {
  const known = filterKnown(trace, new TraceStatistics(trace).take(), []);
  const names = {
    exception: () => 'Illegal data address',
    fc: (code: number) => (code === 6 ? 'Write single register' : 'Read'),
  };
  const texts = (text: string) => completions(text, text.length, known, names).map(({ text }) => text);

  it('find the numbers that have them', () => {
    expect(texts('exception:ill')).toEqual(['02']);
    expect(texts('-exception:ADDR')).toEqual(['02']);
    expect(texts('fc:3,sing')).toEqual(['6']);
    expect(texts('exception:i')).toEqual([]);
    expect(texts('illegal')).toEqual(['exception:02']);
    expect(texts('unit:6 register')).toEqual(['fc:6']);
    // The terms that begin so stand before what is called so.
    expect(texts('da')).toEqual(['exception:02']);
    expect(texts('read')).toEqual(['fc:1', 'fc:3', 'fc:23']);
  });
});

it('offers the ends of connections', () => {
  const made = traceOf([
    {
      bytes: hex('0001 0000 0006 01 03 006B 0003'),
      transport: 'tcp',
      side: 'request',
      from: '10.0.0.1:49152',
      to: '10.0.0.5:502',
    },
    {
      bytes: hex('0002 0000 0006 01 03 006B 0003'),
      transport: 'tcp',
      side: 'request',
      from: 'a b',
      to: '10.0.0.5:502',
    },
  ]);
  const known = filterKnown(made, new TraceStatistics(made).take(), []);
  expect(completions('conn:10.', 8, known).map(({ text, count }) => [text, count])).toEqual([
    ['10.0.0.1:49152', 1],
    ['10.0.0.5:502', 2],
  ]);
  expect(completions('conn:', 5, known)).toHaveLength(2);
});

describe('times', () => {
  it('are completed by those of the first and the last record', () => {
    const offered = (clock?: (time: number) => number) =>
      completions('from:', 5, filterKnown(trace, new TraceStatistics(trace).take(), [], clock), {}).map(
        ({ text }) => text,
      );
    expect(offered()).toEqual(['10:30', '10:46']);
    expect(offered(() => 13.75 * 3600 * SECOND)).toEqual(
      ['2026-12-01T00:15', '2026-12-01T00:31'].map((text) => text.slice(11)),
    );
    expect(offered(() => 13.4 * 3600 * SECOND)).toEqual(['2026-11-30T23:54', '2026-12-01T00:10']);
    for (const time of offered()) expect(kept(`from:${time}`)).not.toEqual([]);
  });
});

describe('a clock that is put back', () => {
  const HOUR = 3600 * SECOND;
  const at = (hours: number, minutes = 0) => Date.UTC(2026, 9, 25, hours, minutes) * 1000;
  // Central Europe on 25 October 2026: at 01:00 UTC the clock goes from 03:00 to 02:00.
  const clock = (time: number) => (time < at(1) ? 2 : 1) * HOUR;
  const span = { first: at(0), last: at(12), clock };
  const moment = (text: string) => {
    const [term] = read(`from:${text}`).terms;
    if (term?.is !== 'time') throw new TypeError(text);
    return momentIn(span, term.moment);
  };

  it.each([
    ['02:10', at(0, 10)],
    ['03:10', at(2, 10)],
    ['12:00', at(11)],
    ['2026-10-25T01:30', at(0) - HOUR / 2],
    ['2026-10-25T12:00', at(11)],
  ])('shows %s once', (text, time) => {
    expect(moment(text)).toBe(time);
  });
});

describe('a clock without a date', () => {
  const HOUR = 3600 * SECOND;
  const clock = (hours: number) => ({ kind: 'clock', time: hours * HOUR }) as const;
  // From 22:00 until 06:00 of the next day, as microseconds since the first record.
  const night = { first: 0, last: 8 * HOUR, clock: () => 22 * HOUR };

  it.each([
    ['23:00', clock(23), 1],
    ['02:00, the next day', clock(2), 4],
    ['21:00, before all', clock(21), -1],
    ['07:00, behind all', clock(7), 9],
  ])('is the nearest day: %s', (_, moment, hours) => {
    expect(momentIn(night, moment)).toBe(hours * HOUR);
  });

  it('is behind the moment from which on', () => {
    const days = { first: 0, last: 48 * HOUR, clock: () => 0 };
    expect(momentIn(days, clock(1), 23 * HOUR)).toBe(25 * HOUR);
  });
});
