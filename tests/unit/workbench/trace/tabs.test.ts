import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import type { PrintedClock } from '../../../../src/captures/index.ts';
import { type Profile, plainRegister } from '../../../../src/devices/index.ts';
import { KnownValues, type TraceInput, TraceStatistics, tallied, traceOf } from '../../../../src/trace/index.ts';
import {
  binNear,
  filterOfAllTimes,
  filterOfKnown,
  filterOfTally,
  filterOfTimes,
  filtersTimes,
  knownAt,
  knownColumns,
  knownCsv,
  knownName,
  knownShown,
  knownUnits,
  MOST_COLUMNS,
  parseFilter,
  profileOfKnown,
  sortedTallies,
  TimelineMaker,
  talliesText,
  tallyValue,
} from '../../../../src/workbench/index.ts';
import { TraceList } from '../../../../src/workbench/trace/trace-list.ts';

const hex = (text: string) => Uint8Array.from(text.match(/[0-9a-f]{2}/gi) ?? [], (pair) => Number.parseInt(pair, 16));
const row = (milliseconds: number | undefined, text: string): TraceInput => ({
  bytes: hex(text),
  time: milliseconds === undefined ? undefined : 1000 * milliseconds,
  place: { kind: 'text', from: 0, to: 1 },
});

// Unit 1: reads 107 to 109 (AP 6.3), writes 1 (AP 6.6), is refused once; unit 17 is silent.
const ASK = '01 03 00 6B 00 03 74 17';
const LOG = [
  row(0, ASK),
  row(10, '01 03 06 02 2B 00 00 00 64 05 7A'),
  row(1000, ASK),
  row(1030, '01 83 02 C0 F1'),
  row(2000, '01 06 00 01 00 03 98 0B'),
  row(2004, '01 06 00 01 00 03 98 0B'),
  row(3000, '11 03 00 6B 00 03 76 87'),
  row(5000, ASK),
  row(5020, '01 03 06 02 2B 00 01 00 64 54 BA'),
];

function timelineOf(
  records: readonly TraceInput[],
  { columns = 5, filter = '', by = 'frame' as const, step = 1e9 } = {},
) {
  const trace = traceOf(records);
  const read = parseFilter(filter);
  if (read.kind !== 'filter') throw new TypeError(filter);
  const list = new TraceList(trace, read, by);
  while (!list.done) list.go(step);
  const maker = new TimelineMaker(trace, list, columns);
  while (!maker.go(step));
  return maker.timeline;
}

describe('a timeline', () => {
  it('has the reply times and the faults of each column, with the rows to go to', () => {
    expect(timelineOf(LOG)).toEqual({
      from: 0,
      to: 5_000_000,
      origin: 0,
      untimed: 0,
      bins: [
        { from: 0, to: 0, exchanges: 1, minimum: 10_000, maximum: 10_000, row: 0, faults: [] },
        {
          from: 1_000_000,
          to: 1_000_000,
          exchanges: 1,
          minimum: 30_000,
          maximum: 30_000,
          row: 2,
          faults: [{ kind: 'exception', count: 1, row: 3 }],
        },
        { from: 2_000_000, to: 2_000_000, exchanges: 1, minimum: 4000, maximum: 4000, row: 4, faults: [] },
        {
          from: 3_000_000,
          to: 3_000_000,
          exchanges: 1,
          minimum: undefined,
          maximum: undefined,
          row: 6,
          faults: [{ kind: 'no-reply', count: 1, row: 6 }],
        },
        { from: 5_000_000, to: 5_000_000, exchanges: 1, minimum: 20_000, maximum: 20_000, row: 7, faults: [] },
      ],
    });
  });

  it('puts together what stands in one column, and leads to the slowest', () => {
    expect(timelineOf(LOG, { columns: 1 }).bins).toEqual([
      {
        from: 0,
        to: 5_000_000,
        exchanges: 5,
        minimum: 4000,
        maximum: 30_000,
        row: 2,
        faults: [
          { kind: 'exception', count: 1, row: 3 },
          { kind: 'no-reply', count: 1, row: 6 },
        ],
      },
    ]);
  });

  it('shows what the filter keeps', () => {
    const { bins } = timelineOf(LOG, { filter: 'unit:17' });
    expect(bins).toHaveLength(1);
    expect(bins[0]).toMatchObject({ exchanges: 1, row: 0, faults: [{ kind: 'no-reply', count: 1, row: 0 }] });
  });

  it('counts exchanges without a time apart', () => {
    const { bins, untimed } = timelineOf([row(undefined, ASK), row(undefined, '01 83 02 C0 F1')]);
    expect([bins.length, untimed]).toEqual([0, 1]);
  });

  it('is the same however many rows are looked at together, and never has more columns than it may', () => {
    const times = fc.array(fc.integer({ min: 0, max: 100_000 }), { maxLength: 60 });
    fc.assert(
      fc.property(times, fc.integer({ min: 1, max: 7 }), fc.integer({ min: 1, max: 2000 }), (steps, step, columns) => {
        let time = 0;
        const records = steps.map((more) => {
          time += more;
          return row(time, ASK);
        });
        const made = timelineOf(records, { columns, step });
        expect(made).toEqual(timelineOf(records, { columns }));
        expect(made.bins.length).toBeLessThanOrEqual(Math.min(columns, MOST_COLUMNS));
        expect(made.bins.reduce((sum, { exchanges }) => sum + exchanges, 0)).toBe(records.length);
      }),
      { numRuns: 60 },
    );
  });

  it('tells the column that is nearest to a time', () => {
    const timeline = timelineOf(LOG);
    expect([-1, 1_400_000, 4_100_000, 9e9].map((time) => binNear(timeline, time))).toEqual([0, 1, 4, 4]);
    expect(binNear({ bins: [] }, 0)).toBeUndefined();
  });
});

describe('filters of the tabs', () => {
  const statistics = new TraceStatistics(traceOf(LOG)).take();
  const known = knownColumns(new KnownValues(traceOf(LOG)).take().list);

  it('show the exchanges of a row, in the place of another row, beside what else is filtered', () => {
    expect(filterOfTally('', statistics.by('unit')[1]!)).toBe('unit:17');
    expect(filterOfTally('crc unit:6 from:1', statistics.by('function')[1]!)).toBe('crc from:1 fc:6');
    expect(filterOfTally('addr:5', statistics.by('address')[0]!)).toBe('unit:1 fc:3 addr:40108');
    expect(filterOfTally('', statistics.by('poll')[0]!)).toBe('unit:1 fc:3 addr:40108-40110');
    expect(filterOfKnown('late', knownAt(known, 2))).toBe('late unit:1 addr:40109');
  });

  it('show a part of the time', () => {
    expect(filterOfTimes('crc to:99', 5_000_000, 6_500_000.4, 7_000_000.5)).toBe('crc from:1.500000 to:2.000001');
    // 10:31:00 on some day, and past its midnight; on 30 November 2026; 5 seconds from a start.
    const times = (from: number, to: number, clock: PrintedClock) => filterOfTimes('', 0, from, to, clock);
    const morning = { shows: 'day', shift: 37_860_000_000 } as const;
    expect(times(1_500_000, 60_000_000, morning)).toBe('from:10:31:01.500000 to:10:32');
    expect(times(0, 50_000_000_000, morning)).toBe('from:10:31 to:50000');
    const [day, date] = [1_796_034_660_000_000, { shows: 'date', shift: 0 } as const];
    expect(filterOfTimes('', day, day, day + 4, date)).toBe('from:2026-11-30T10:31 to:2026-11-30T10:31:00.000004');
    expect(times(1_000_000, 2_000_000, { shows: 'count', shift: 5_000_000 })).toBe('from:1 to:2');
    expect(filterOfAllTimes('crc from:1.500000 to:2')).toBe('crc');
    expect([filtersTimes('crc'), filtersTimes('crc from:1')]).toEqual([false, true]);
  });

  it('take the place of a filter that cannot be read', () => {
    expect(filterOfTally('nonsense:1', statistics.by('unit')[0]!)).toBe('unit:1');
  });

  it('find the exchanges that were counted', () => {
    const replies = [1, 3, 5];
    const said = LOG.map((record, index): TraceInput => {
      const ends = ['10.0.0.2:49152', index < 4 ? '10.0.0.5:502' : '10.0.0.6:502'] as const;
      const [from, to] = replies.includes(index) ? ends.toReversed() : ends;
      return { ...record, side: replies.includes(index) ? 'response' : 'request', from, to };
    });
    for (const log of [LOG, said]) {
      const counted = new TraceStatistics(traceOf(log)).take();
      for (const tally of tallied.flatMap((by) => counted.by(by))) {
        const filter = filterOfTally('', tally);
        const found = timelineOf(log, { filter }).bins.reduce((sum, { exchanges }) => sum + exchanges, 0);
        expect([filter, found]).toEqual([filter, tally.exchanges]);
      }
    }
    expect(filterOfTally('unit:6', new TraceStatistics(traceOf(said)).take().by('connection')[0]!)).toBe(
      'conn:"10.0.0.2:49152 → 10.0.0.5:502"',
    );
  });
});

describe('statistics as a table', () => {
  const statistics = new TraceStatistics(traceOf(LOG)).take();
  const words = {
    columns: {
      unit: 'unit',
      functionCode: 'function',
      address: 'address',
      quantity: 'quantity',
      connection: 'connection',
      exchanges: 'exchanges',
      replies: 'replies',
      faults: 'faults',
      minimum: 'min',
      median: 'median',
      p95: 'p95',
      maximum: 'max',
      interval: 'interval',
    },
    fault: (kind: string) => kind,
    exceptions: 'exceptions',
    exception: (code: number, count: number) => `${code} × ${count}`,
    functionName: (code: number) => `F${code}`,
    noConnection: '-',
  };

  it('are sorted by any column, and what has no value stands last', () => {
    const units = statistics.by('unit');
    const order = (down: boolean) => sortedTallies(units, { by: 'median', down }).map(({ unit }) => unit);
    expect([order(false), order(true)]).toEqual([
      [1, 17],
      [1, 17],
    ]);
    expect(sortedTallies(units, { by: 'exchanges', down: false }).map(({ unit }) => unit)).toEqual([17, 1]);
    expect(sortedTallies(units, undefined)).toBe(units);
    expect(tallyValue(units[0]!, 'faults')).toBe(1);
  });

  it('are copied with a column for each kind of fault, and their times in milliseconds', () => {
    expect(talliesText('unit', statistics.by('unit'), words, 'csv').split('\n')).toEqual([
      'unit,exchanges,replies,exception,no-reply,min (ms),median (ms),p95 (ms),max (ms),exceptions',
      '1,4,4,1,0,4,15,30,30,2 × 1',
      '17,1,0,0,1,,,,,',
    ]);
    expect(talliesText('poll', statistics.by('poll').slice(0, 1), words, 'csv').split('\n')[0]).toBe(
      'unit,function,address,quantity,exchanges,replies,exception,min (ms),median (ms),p95 (ms),max (ms),interval (ms),exceptions',
    );
  });
});

describe('what is known of each unit', () => {
  const known = knownColumns(new KnownValues(traceOf(LOG)).take().list);
  const device: Profile = {
    id: 'pump',
    name: 'Pump',
    source: '',
    convention: 'zero-based',
    traits: [],
    notes: [],
    registers: [
      {
        ...plainRegister,
        name: 'P107 speed',
        table: 'holding-register',
        address: 107,
        type: 'u32',
        factor: 0.1,
        unit: 'Hz',
        access: 'r',
      },
    ],
  };

  it('comes in columns, and as before', () => {
    const { list } = new KnownValues(traceOf(LOG)).take();
    expect(list.map((_, at) => knownAt(known, at))).toEqual(list);
    expect(() => knownAt(known, 4)).toThrow(RangeError);
    expect(knownUnits(known)).toEqual([1]);
  });

  it('is chosen by unit and by whether it changed', () => {
    expect([...knownShown(known, { unit: undefined, changed: false })]).toEqual([0, 1, 2, 3]);
    expect([...knownShown(known, { unit: 1, changed: true })]).toEqual([2]);
    expect([...knownShown(known, { unit: 17, changed: false })]).toEqual([]);
  });

  it('has the names and values of the device', () => {
    expect(knownName(known, 1, undefined)).toBeUndefined();
    // 0x022B0001 tenths.
    expect(knownName(known, 1, device)).toMatchObject({
      name: 'P107 speed',
      value: { raw: 0x022b_0001, cutOff: false },
    });
    expect(knownName(known, 2, device)).toEqual({ name: 'P107 speed', value: undefined });
    expect(knownName(known, 3, device)).toBeUndefined();
  });

  it('is a table for spreadsheets', () => {
    const column = (name: string) => name;
    const words = {
      columns: {
        unit: column('unit'),
        table: 'table',
        address: 'address',
        number: 'number',
        name: 'name',
        value: 'value',
        means: 'means',
        when: 'when',
        reads: 'reads',
        writes: 'writes',
        changes: 'changes',
      },
      table: (table: string) => table,
      inUnits: () => 'in Hz',
    };
    const text = knownCsv(known, knownShown(known, { unit: 1, changed: false }), device, words);
    expect(text.split('\r\n').slice(1, 3)).toEqual([
      '1,holding-register,1,40002,,3,,2.004000,0,1,0',
      '1,holding-register,107,40108,P107 speed,555,in Hz,5.020000,2,0,0',
    ]);
  });

  it('becomes a profile: what the device has, and plain registers', () => {
    const made = profileOfKnown(known, 1, device, { name: 'Unit 1', source: 'a log' });
    expect(made).toMatchObject({ name: 'Unit 1', source: 'a log', convention: 'zero-based' });
    expect(made.registers.map(({ name, address, access }) => [name, address, access])).toEqual([
      ['40002', 1, 'rw'],
      ['P107 speed', 107, 'r'],
      ['40110', 109, 'r'],
    ]);
    expect(profileOfKnown(known, 1, undefined, { name: '', source: '' })).toMatchObject({
      convention: 'five-digit',
      registers: { length: 4 },
    });
  });
});
