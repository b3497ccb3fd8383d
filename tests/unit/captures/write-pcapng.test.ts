import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { readCapture, writePcapng, writeTraceJson } from '../../../src/captures/index.ts';
import { traceOf } from '../../../src/trace/index.ts';
import { hex, joined, REPLY, REQUEST } from './wire.ts';

const tcp = (bytes: Uint8Array, side: 'request' | 'response', time: number) => {
  const [from, to] = side === 'request' ? ['192.0.2.1:49152', '192.0.2.2:502'] : ['192.0.2.2:502', '192.0.2.1:49152'];
  return { bytes, side, time, from, to, transport: 'tcp' as const };
};

describe('frames of TCP', () => {
  it('have headers of Ethernet, IPv4 and TCP with their checksums', () => {
    const written = writePcapng([tcp(REQUEST, 'request', 1_000_000)]);
    const packet = joined(
      hex('020000000002 020000000001 0800'),
      // Version and length, 52 bytes, not to be parted, 64 hops, TCP, checksum, the two ends.
      hex('4500 0034 0000 4000 4006 B6C0 C0000201 C0000202'),
      // Ports, sequence 1, acknowledged 1, five words, PSH and ACK, window, checksum.
      hex('C000 01F6 00000001 00000001 5018 FFFF 684C 0000'),
      REQUEST,
    );
    // Section header and interface take 48 bytes, the head of the packet 28.
    expect(written.subarray(76, 76 + packet.length)).toEqual(packet);
  });

  it('are read back with their ends, sides and times', () => {
    const records = [tcp(REQUEST, 'request', 5_000_000), tcp(REPLY, 'response', 5_004_000)];
    expect(Array.from(readCapture(writePcapng(records)).records)).toMatchObject(records);
  });
});

const rtu = { bytes: hex('11 03 00 6B 00 03 76 87'), side: 'request', transport: 'rtu', time: 2_000_000 } as const;
const reply = {
  bytes: hex('11 03 06 AE 41 56 52 43 40 49 AD'),
  side: 'response',
  transport: 'rtu',
  time: 3_500_000,
} as const;

it('frames of a serial line are upper PDUs of Wireshark, and simple packets if they have no time', () => {
  const head = [
    // Section header: type, length 28, byte order, version 1.0, section length unknown, length.
    '0A0D0D0A 1C000000 4D3C2B1A 0100 0000 FFFFFFFFFFFFFFFF 1C000000',
    // Interface: type 1, length 20, upper PDUs (252), no limit, length.
    '01000000 14000000 FC00 0000 00000000 14000000',
  ];
  // Dissector "mbrtu", port type UDP, ports, end.
  const tags = (ports: string) => `000C 0008 6D62727475000000 0018 0004 00000003 ${ports} 0000 0000`;
  const wanted = [
    ...head,
    // Enhanced packet: type 6, length 80, interface 0, 2,000,000 µs, 48 bytes kept of 48.
    '06000000 50000000 00000000 00000000 80841E00 30000000 30000000',
    tags('0019 0004 0000C000 001A 0004 000001F6'),
    '1103006B00037687 50000000',
    // Simple packet: type 3, length 68, 51 bytes, filled up to 52.
    '03000000 44000000 33000000',
    tags('0019 0004 000001F6 001A 0004 0000C000'),
    '110306AE415652434049AD 00 44000000',
  ];
  const written = writePcapng([rtu, { ...reply, time: undefined }]);
  expect(Buffer.from(written).toString('hex')).toBe(Buffer.from(hex(wanted.join(''))).toString('hex'));
});

it('frames of a serial line and of TCP stand in one file, each on an interface of its own', () => {
  const records = [rtu, tcp(REQUEST, 'request', 3_000_000), reply, tcp(REPLY, 'response', 4_000_000)];
  const { records: read, problems } = readCapture(writePcapng(records));
  expect(problems).toEqual([]);
  expect(Array.from(read, ({ bytes, transport }) => [bytes, transport])).toEqual(
    [rtu, records[1], reply, records[3]].map((one) => [one?.bytes, one?.transport]),
  );
});

it('any conversation is read back as it was written', () => {
  const anyExchange = fc.tuple(fc.nat(3), fc.nat(65_535), fc.nat(120));
  fc.assert(
    fc.property(fc.array(anyExchange, { minLength: 1, maxLength: 20 }), (all) => {
      const records = all.flatMap(([host, transaction, count], at) => {
        const id = transaction.toString(16).padStart(4, '0');
        const ends = [`host ${host}`, 'plc:502'];
        const two = (value: number) => value.toString(16).padStart(2, '0');
        return [
          {
            ...tcp(hex(`${id} 0000 0006 01 03 0000 00${two(count + 1)}`), 'request', at * 1e6),
            from: ends[0],
            to: ends[1],
          },
          {
            ...tcp(
              joined(
                hex(`${id} 0000 00${two(2 * (count + 1) + 3)} 01 03 ${two(2 * (count + 1))}`),
                new Uint8Array(2 * (count + 1)),
              ),
              'response',
              at * 1e6 + 1000,
            ),
            from: ends[1],
            to: ends[0],
          },
        ];
      });
      const { records: read, problems } = readCapture(writePcapng(records));
      expect(problems).toEqual([]);
      expect(Array.from(read, ({ bytes, side, time }) => ({ bytes, side, time }))).toEqual(
        records.map(({ bytes, side, time }) => ({ bytes, side, time })),
      );
    }),
  );
});

describe('as JSON', () => {
  it('is read back', () => {
    const records = [rtu, { ...reply, time: undefined }, tcp(REQUEST, 'request', 1.5)].map((one) => ({
      ...one,
      place: { kind: 'live' } as const,
    }));
    const { format, records: read } = readCapture(new TextEncoder().encode(writeTraceJson(records)));
    expect(format).toBe('json');
    expect(Array.from(read)).toEqual(
      records.map(({ time, ...one }, index) => ({
        ...one,
        ...(time !== undefined && { time }),
        place: { kind: 'packet', numbers: [index + 1] },
      })),
    );
  });

  it('reads what the page saved of its bus before', () => {
    const lines = [
      { number: 1, time: 1000, direction: 'sent', transport: 'rtu', kind: 'request', hex: '1103006B00037687' },
      { number: 2, time: 1010, direction: 'received', transport: 'rtu', kind: 'reply', hex: '110306AE415652434049AD' },
      { number: 3, time: 'x', hex: 5 },
      null,
    ];
    const text = JSON.stringify({ format: 'framewright log', version: 1, lines }, null, 1);
    const { records } = readCapture(new TextEncoder().encode(text));
    expect(Array.from(records)).toMatchObject([
      { side: 'request', time: 1_000_000 },
      { side: 'response', time: 1_010_000 },
    ]);
    expect(traceOf(records).summary()).toMatchObject({ exchanges: 1, faults: { 'no-reply': 0 } });
  });
});
