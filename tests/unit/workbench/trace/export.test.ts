import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { readCapture } from '../../../../src/captures/index.ts';
import { encodeFrame } from '../../../../src/modbus/index.ts';
import { besides, type Trace, type TraceInput, traceOf } from '../../../../src/trace/index.ts';
import { demoLog, exportFormats, exportName, isDated } from '../../../../src/workbench/index.ts';
import { hex } from '../../captures/wire.ts';
import { exported } from './exported.ts';
import { anyAct, anyTwoWorlds, happened, seen } from './worlds.ts';

const place = { kind: 'text', from: 0, to: 0 } as const;
const bytesOf = (text: string) => new TextEncoder().encode(text);
const all = { units: true, addresses: true, times: true };
const demo = () => traceOf(readCapture(bytesOf(demoLog())).records);

/** What a record is, wherever it stands. */
const plain = (record: TraceInput) => ({
  bytes: Buffer.from(record.bytes).toString('hex'),
  time: record.time,
  side: record.side,
  transport: record.transport,
  from: record.from,
  to: record.to,
  known: record.known,
});
type Plain = ReturnType<typeof plain>;
const recordsOf = (trace: ReturnType<typeof traceOf>) =>
  Array.from({ length: trace.size }, (_, index) => plain(trace.plain(index)));
const readAgain = (bytes: Uint8Array) => Array.from(readCapture(bytes).records, plain);

/** An exchange of a serial line, with damage or without, or one of TCP. */
const anyExchange = fc
  .record({
    unit: fc.integer({ min: 1, max: 247 }),
    address: fc.nat(65_000),
    transport: fc.constantFrom('rtu', 'tcp'),
    gap: fc.nat(3_000_000),
    after: fc.option(fc.nat(900_000)),
    damaged: fc.boolean(),
    host: fc.nat(3),
  })
  .map(({ unit, address, transport, gap, after, damaged, host }) => {
    const common = { transport, unitId: unit, functionCode: 3 } as const;
    const ends = transport === 'tcp' ? [`10.0.0.${host}:${50_000 + host}`, '10.0.0.9:502'] : [];
    const ask = encodeFrame({ ...common, direction: 'request', fields: { startAddress: address, quantity: 2 } });
    const answer = encodeFrame({ ...common, direction: 'response', fields: { registers: [address, 7] } });
    if (damaged && transport === 'rtu') answer[5] = (answer[5] ?? 0) ^ 4;
    return { ask, answer, transport, gap, after, ends };
  });

/** Their records in the order of time, which begins in 2026. */
const anyConversation = fc.array(anyExchange, { minLength: 1, maxLength: 12 }).map((list) => {
  let time = 1000 * Date.UTC(2026, 10, 30, 10, 31);
  return list.flatMap(({ ask, answer, transport, gap, after, ends: [client, server] }): TraceInput[] => {
    time += gap + 1_000_000;
    const request = { bytes: ask, transport, time, side: 'request', from: client, to: server, place } as const;
    if (after === null) return [request];
    return [
      request,
      { bytes: answer, transport, time: time + after, side: 'response', from: server, to: client, place },
    ];
  });
});

describe('what is saved is read again', () => {
  it.each(['csv', 'json', 'pcapng'] as const)('as %s, with the same bytes, times, sides and ends', (format) => {
    fc.assert(
      fc.property(anyConversation, (inputs) => {
        const trace = traceOf(inputs);
        const { bytes } = exported(trace, format);
        expect(readCapture(bytes)).toMatchObject({ format, problems: [] });
        // A capture has no names for the ends of a serial line, and packets of one moment in the order of their lines.
        const wanted = recordsOf(trace);
        const order = (one: Plain, other: Plain) => (one.time ?? 0) - (other.time ?? 0);
        expect(readAgain(bytes)).toEqual(format === 'pcapng' ? [...wanted].sort(order) : wanted);
      }),
    );
  });

  it.each(['csv', 'json'] as const)('as %s, with what its source knows', (format) => {
    const trace = traceOf(
      besides.map((beside, time) => ({ bytes: hex('01 83 02 C0 F1'), time, place, known: { beside } })),
    );
    expect(readAgain(exported(trace, format).bytes)).toEqual(recordsOf(trace));
  });

  it.each(['csv', 'json', 'pcapng'] as const)('as %s, without times', (format) => {
    const trace = traceOf(
      ['11 03 006B 0003 7687', '11 03 06 022B 0000 0064 C8BA'].map((text) => ({ bytes: hex(text), place })),
    );
    const read = readAgain(exported(trace, format).bytes);
    expect(read.map(({ bytes, time }) => [bytes, time])).toEqual(
      recordsOf(trace).map(({ bytes }) => [bytes, undefined]),
    );
  });

  it('as pcapng, ASCII frames as RTU, and damaged ones as damaged', () => {
    const saved = (text: string) => {
      const trace = traceOf([{ bytes: bytesOf(text), transport: 'ascii', side: 'request', place }]);
      return Buffer.from(exported(trace, 'pcapng').bytes).toString('hex').toUpperCase();
    };
    expect(saved(':1103006B00037E\r\n')).toContain('1103006B00037687');
    // 7687 with each bit another.
    expect(saved(':1103006B00037F\r\n')).toContain('1103006B00038978');
    expect(saved(':0105FA\r\n')).toContain('0105');
    expect(saved(':01\r\n')).toContain(Buffer.from(':01\r\n').toString('hex').toUpperCase());
  });

  const zone = () => 7_200_000_000;
  const line = (time: string) => `${time} Tx 11 03 00 6B 00 03 76 87`;
  /** The first time of a log and of what it is saved as: as the page shows it, two hours ahead of UTC. */
  const shownTimes = (bytes: Uint8Array) => {
    const { records, clock } = readCapture(bytes);
    return Array.from(records, ({ time = 0 }) => {
      const shown = time + (clock?.shift ?? (isDated(time) ? zone() : 0));
      return new Date(shown / 1000).toISOString().replace(/^1970-01-0\dT/, '');
    });
  };
  const clocks = {
    'a time of day': ['23:59:59.250', '00:00:01.500'],
    'a date': ['2026-11-30 10:31:00.004', '2026-12-01 00:00:00.000'],
    'a date with its zone': ['2026-11-30T10:31:00.004-05:00', '2026-11-30T10:31:07.000-05:00'],
    'a count of seconds': ['12.345678', '13.000000'],
  } as const;
  const kept = Object.entries(clocks).flatMap(([name, times]) =>
    (['csv', 'json', 'pcapng'] as const).map((format) => [name, format, times] as const),
  );

  it.each(kept)('with the clock that its log prints: %s, as %s', (name, format, times) => {
    const text = bytesOf(times.map(line).join('\n'));
    const { records, clock } = readCapture(text);
    const { bytes } = exported(traceOf(records), format, {}, { clock, zone });
    const shown = shownTimes(text);
    // A capture has no zone: it is shown by the reader's clock.
    if (format === 'pcapng' && name === 'a date with its zone')
      expect(shownTimes(bytes)[0]).toBe('2026-11-30T17:31:00.004Z');
    else expect(shownTimes(bytes)).toEqual(shown);
    if (format !== 'pcapng') expect(readCapture(bytes).clock?.shows).toBe(clock?.shows);
  });

  it('as a table and a report, with times as they were printed, and with none that are replaced', () => {
    const text = (times: readonly string[], format: 'csv' | 'report', replaced = {}) => {
      const { records, clock } = readCapture(bytesOf(times.map(line).join('\n')));
      return Buffer.from(exported(traceOf(records), format, replaced, { clock, zone }).bytes).toString();
    };
    for (const format of ['csv', 'report'] as const) {
      expect(text(clocks['a time of day'], format)).toContain('23:59:59.250000');
      expect(text(clocks['a date'], format)).toMatch(/2026-11-30T10:31:00.004000(?!Z)/);
      expect(text(clocks['a date with its zone'], format)).toContain('2026-11-30T10:31:00.004000-05:00');
      expect(text(clocks['a time of day'], format, { times: true })).not.toContain('23:59');
    }
    expect(text(clocks['a time of day'], 'csv', { times: true })).toContain(',0.000000,');
  });

  it('with what is in no frame, but for its words in a capture and where something is replaced', () => {
    const capture = readCapture(bytesOf('Tx 11 03 00 6B 00 03 76 87\nRx FF 0G 1H FE FD'));
    const trace = traceOf([...Array.from(capture.records), ...(capture.pieces ?? []).map(({ record }) => record)]);
    expect(trace.pieces).toBeGreaterThan(1);
    const json = exported(trace, 'json').bytes;
    expect(readAgain(json)).toEqual(recordsOf(trace));
    for (const format of exportFormats)
      expect(exported(trace, format, { units: true }).bytes.toString()).not.toContain('0G');
    expect(readCapture(exported(trace, 'pcapng').bytes).problems).toEqual([]);
  });

  it('also only the frames that a filter keeps', () => {
    const trace = demo();
    const { bytes } = exported(trace, 'csv', {}, { indexes: [3, 5, 8] });
    expect(readAgain(bytes)).toEqual([3, 5, 8].map((index) => recordsOf(trace)[index]));
  });
});

describe('what is replaced', () => {
  it('leaves no trace in the file: two logs that differ in nothing else are the same in all formats', () => {
    fc.assert(
      fc.property(anyTwoWorlds, fc.array(anyAct, { minLength: 1, maxLength: 12 }), (worlds, acts) => {
        const [left, right] = worlds.map((world) => traceOf(happened(world, acts)));
        fc.pre(left !== undefined && right !== undefined && seen(left) === seen(right));
        const texts = (trace: Trace) =>
          exportFormats.map((format) => Buffer.from(exported(trace, format, all).bytes).toString('latin1'));
        expect(texts(left)).toEqual(texts(right));
      }),
      { numRuns: 60 },
    );
  });

  it('keeps what is not to be replaced, and says nothing of the source, the filter and the names', () => {
    const trace = demo();
    const of = { source: 'unit 6.txt', filter: 'unit:6', indexes: [0, 1] };
    const report = (replaced: object) => Buffer.from(exported(trace, 'report', replaced, of).bytes).toString();
    expect(report({})).toContain('- unit 6.txt\n');
    expect(report({})).toContain('the filter `unit:6` keeps');
    expect(report({ times: true })).not.toMatch(/unit 6.txt|unit:6/);
    expect(recordsOf(trace).map(({ bytes }) => bytes)).toEqual(
      readAgain(exported(trace, 'json', { times: true }).bytes).map(({ bytes }) => bytes),
    );
    expect(exportName({ format: 'report', replaced: { units: true } }, 'unit 6.txt')).toBe('log-replaced.md');
    expect(exportName({ format: 'pcapng', replaced: {} }, 'bus.pcap.gz')).toBe('bus-saved.pcapng');
    expect(exportName({ format: 'csv', replaced: { units: false } }, undefined)).toBe('log-saved.csv');
  });
});

it('tells how far it is, and never goes back', () => {
  const frame = { bytes: hex('06 03 02 A9 00 01 54 25'), place };
  const trace = traceOf(Array.from({ length: 4100 }, (_, time) => ({ ...frame, time })));
  for (const format of exportFormats) {
    for (const replaced of [{}, all]) {
      const { steps } = exported(trace, format, replaced);
      expect(steps.length).toBeGreaterThan(1);
      expect([...steps].sort((one, other) => one - other)).toEqual(steps);
      expect(Math.max(...steps)).toBeLessThanOrEqual(1);
    }
  }
});
