import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  type LogLine,
  logAsCsv,
  logAsJson,
  logAsPcapng,
  logAsText,
  logFromJson,
  logFromPcapng,
  logFromRows,
} from '../../../src/bus/index.ts';
import { toHex } from '../../../src/modbus/index.ts';
import { readBytes } from '../../../src/notation/index.ts';
import { parseCsv } from '../../../src/ui/parts/csv.ts';
import { csvRows } from '../../../src/workbench/devices/profile-csv.ts';
import { anyBytes } from '../modbus/arbitraries.ts';
import { hex } from '../modbus/frames.ts';

/** 1 January 2026, 12:00:00.250 UTC. */
const NOON = Date.UTC(2026, 0, 1, 12, 0, 0, 250);

const LOG: readonly LogLine[] = [
  {
    number: 1,
    time: NOON,
    direction: 'sent',
    transport: 'rtu',
    kind: 'request',
    hex: '1103006B00037687',
    duration: 20.25,
    verdict: 'good',
  },
  {
    number: 2,
    time: NOON + 20,
    direction: 'received',
    transport: 'rtu',
    kind: 'reply',
    hex: '110306AE415652434049AD',
    answers: 1,
  },
];

const fromCsv = (text: string) => logFromRows(csvRows(text, ',', parseCsv).map(({ cells }) => cells));

/** Lines as the session makes them: a reply answers a request before it. */
const anyLog: fc.Arbitrary<readonly LogLine[]> = fc
  .array(
    fc.record({
      time: fc.integer({ min: 0, max: 4_000_000_000_000 }),
      transport: fc.constantFrom('rtu' as const, 'ascii' as const),
      bytes: anyBytes.filter(({ length }) => length > 0),
      tenths: fc.nat(100_000),
      verdict: fc.constantFrom(
        'good' as const,
        'doubtful' as const,
        'refused' as const,
        'bad' as const,
        'silent' as const,
        'absent' as const,
      ),
      kind: fc.constantFrom(
        'reply' as const,
        'exception' as const,
        'broken' as const,
        'noise' as const,
        'heard' as const,
      ),
    }),
    { minLength: 1, maxLength: 12 },
  )
  .map((parts) =>
    parts.map(({ time, transport, bytes, tenths, verdict, kind }, index): LogLine => {
      const line = { number: index + 1, time, transport, hex: toHex(bytes) };
      if (index % 2 === 0) return { ...line, direction: 'sent', kind: 'request', duration: tenths / 10, verdict };
      const answers = kind === 'reply' || kind === 'exception' || kind === 'broken';
      return { ...line, direction: 'received', kind, ...(answers && { answers: index }) };
    }),
  );

describe('as text', () => {
  test('a line has its time, direction and bytes', () => {
    expect(logAsText(LOG)).toBe(
      '2026-01-01T12:00:00.250Z TX 11 03 00 6B 00 03 76 87\n' +
        '2026-01-01T12:00:00.270Z RX 11 03 06 AE 41 56 52 43 40 49 AD\n',
    );
  });

  test('is read again when it is pasted', () => {
    expect(readBytes(logAsText(LOG)).bytes).toEqual(hex('1103006B00037687 110306AE415652434049AD'));
  });
});

describe('as a table', () => {
  test('has a row for each line', () => {
    expect(logAsCsv(LOG)).toBe(
      'number,time,direction,transport,kind,bytes,answers,duration_ms,verdict\r\n' +
        '1,2026-01-01T12:00:00.250Z,sent,rtu,request,11 03 00 6B 00 03 76 87,,20.3,good\r\n' +
        '2,2026-01-01T12:00:00.270Z,received,rtu,reply,11 03 06 AE 41 56 52 43 40 49 AD,1,,\r\n',
    );
  });

  test('gives the log back', () => {
    fc.assert(
      fc.property(anyLog, (log) => {
        expect(fromCsv(logAsCsv(log))).toEqual(log);
      }),
    );
  });

  test('is read with its columns in another order, and with what a spreadsheet makes of it', () => {
    const text =
      'bytes;direction;time;duration_ms;number\r\n' +
      '11 03 00 6b 00 03 76 87;sent;2026-01-01T12:00:00.250Z;20,3;7\r\n' +
      'nothing;sent;2026-01-01T12:00:00.250Z;;8\r\n' +
      '11 03;received;yesterday;;9\r\n';
    expect(logFromRows(csvRows(text, ';', parseCsv).map(({ cells }) => cells))).toEqual([
      {
        number: 1,
        time: NOON,
        direction: 'sent',
        transport: 'rtu',
        kind: 'heard',
        hex: '1103006B00037687',
        duration: 20.3,
      },
    ]);
  });

  test('without the columns that a log needs is none', () => {
    expect(logFromRows([])).toBeUndefined();
    expect(fromCsv('name,address\r\nspeed,683\r\n')).toBeUndefined();
  });
});

describe('as JSON', () => {
  test('gives the log back', () => {
    fc.assert(
      fc.property(anyLog, (log) => {
        expect(logFromJson(logAsJson(log))).toEqual(log);
      }),
    );
  });

  test('counts anew where lines cannot be read', () => {
    const [request, reply] = LOG;
    const lines = [
      { ...request, number: 3, hex: 'XY' },
      { ...request, number: 5 },
      { ...reply, number: 6, answers: 5, verdict: 'splendid', kind: 'song' },
      { ...reply, number: 7, answers: 3 },
      null,
      { ...reply, time: 'noon' },
    ];
    expect(logFromJson(JSON.stringify({ format: 'framewright log', version: 1, lines }))).toEqual([
      { ...request, number: 1 },
      { ...reply, number: 2, answers: 1, kind: 'heard' },
      { number: 3, time: NOON + 20, direction: 'received', transport: 'rtu', kind: 'reply', hex: reply?.hex },
    ]);
  });

  test.each(['', '{', 'null', '[]', '{"format":"other","lines":[]}', '{"format":"framewright log","lines":7}'])(
    'of something else is none: %s',
    (text) => expect(logFromJson(text)).toBeUndefined(),
  );
});

describe('as a capture', () => {
  test('has the bytes of the format', () => {
    const request = [
      // Section header: type, length 28, byte order, version 1.0, section length unknown, length
      '0A0D0D0A 1C000000 4D3C2B1A 0100 0000 FFFFFFFFFFFFFFFF 1C000000',
      // Interface: type 1, length 20, upper PDUs (252), no limit, length
      '01000000 14000000 FC00 0000 00000000 14000000',
      // Packet: type 6, length 100, interface 0
      '06000000 64000000 00000000',
      // 1767268800250000 µs since 1970, captured length 48, original length 48
      '52470600 90C00F55 30000000 30000000',
      // Tags: dissector "mbrtu", port type UDP, from port 49152 to 502, end
      '000C 0008 6D62727475000000',
      '0018 0004 00000003',
      '0019 0004 0000C000',
      '001A 0004 000001F6',
      '0000 0000',
      '1103006B00037687',
      // Comment "sent request", end, length
      '0100 0C00 73656E742072657175657374',
      '00000000 64000000',
    ];
    expect(toHex(logAsPcapng(LOG.slice(0, 1)))).toBe(toHex(hex(request.join(' '))));
  });

  test('gives frames, times and directions back', () => {
    fc.assert(
      fc.property(anyLog, (log) => {
        const rtu = log.map((line) => ({ ...line, transport: 'rtu' as const }));
        const bare = rtu.map(({ number, time, direction, transport, hex, kind }) => ({
          number,
          time,
          direction,
          transport,
          hex,
          kind: kind === 'request' ? kind : 'heard',
        }));
        expect(logFromPcapng(logAsPcapng(rtu))).toEqual(bare);
      }),
    );
  });

  test('has an ASCII frame as the RTU frame that says the same', () => {
    const ascii = Buffer.from(':1103006B00037E\r\n').toString('hex').toUpperCase();
    const [line] = LOG;
    const log = line && [{ ...line, transport: 'ascii' as const, hex: ascii }];
    expect(logFromPcapng(logAsPcapng(log ?? []))).toMatchObject([{ transport: 'rtu', hex: '1103006B00037687' }]);
  });

  test('that is cut off anywhere, or changed, or none, is read without throwing', () => {
    const whole = logAsPcapng(LOG);
    for (let cut = 0; cut < whole.length; cut++) {
      const lines = logFromPcapng(whole.subarray(0, cut));
      expect(lines?.length ?? 0, `cut at ${cut}`).toBeLessThan(2);
    }
    expect(logFromPcapng(logAsPcapng([]))).toBeUndefined();
    fc.assert(
      fc.property(fc.nat(whole.length - 1), fc.nat(255), (at, value) => {
        const changed = whole.slice();
        changed[at] = value;
        logFromPcapng(changed);
      }),
    );
    fc.assert(fc.property(anyBytes, (bytes) => logFromPcapng(bytes) === undefined));
  });
});
