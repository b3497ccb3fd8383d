import { describe, expect, it } from 'vitest';
import { readCapture } from '../../../src/captures/index.ts';
import { hex, joined, pcap } from './wire.ts';

const REQUEST = hex('01 03 00 6B 00 03 74 17');
const REPLY = hex('01 03 06 02 2B 00 00 00 64 05 7A');
const text = (bytes: Uint8Array) => Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
const found = (bytes: Uint8Array) =>
  Array.from(readCapture(bytes).records, ({ bytes, side, transport, place }) => [
    text(bytes),
    transport,
    side,
    place.kind === 'packet' ? place.numbers : [],
  ]);

/** A packet of LINKTYPE_RTAC_SERIAL: time stamp, event, control lines, footer. */
const rtac = (event: number, payload: Uint8Array) => joined(new Uint8Array(8), [event, 0, 0, 0], payload);
const SENT = 1;
const RECEIVED = 2;

describe('a serial capture', () => {
  it('of an RTAC tells who spoke, and who the server is by what they say', () => {
    const file = pcap(
      [
        { bytes: rtac(0, new Uint8Array()) },
        { bytes: rtac(SENT, REQUEST), fraction: 100 },
        { bytes: rtac(RECEIVED, REPLY.subarray(0, 5)), fraction: 9000 },
        { bytes: rtac(RECEIVED, REPLY.subarray(5)), fraction: 9800 },
      ],
      { link: 250 },
    );
    expect(found(file)).toEqual([
      [text(REQUEST), 'rtu', 'request', [2]],
      [text(REPLY), 'rtu', 'response', [3, 4]],
    ]);
  });

  it.each([147, 155, 162])('of user link type %i is RTU, without a side', (link) => {
    const file = pcap([{ bytes: REQUEST }, { bytes: REPLY, fraction: 9000 }], { link });
    expect(found(file)).toEqual([
      [text(REQUEST), 'rtu', undefined, [1]],
      [text(REPLY), 'rtu', undefined, [2]],
    ]);
  });

  it('keeps a damaged frame as it was heard', () => {
    const damaged = REPLY.with(4, 0xff);
    const file = pcap([{ bytes: REQUEST }, { bytes: damaged, fraction: 9000 }, { bytes: REQUEST, fraction: 500_000 }], {
      link: 147,
    });
    expect(found(file).map(([bytes]) => bytes)).toEqual([text(REQUEST), text(damaged), text(REQUEST)]);
  });

  it('has several frames in one packet', () => {
    expect(found(pcap([{ bytes: joined(REQUEST, REPLY) }], { link: 147 })).map(([bytes]) => bytes)).toEqual([
      text(REQUEST),
      text(REPLY),
    ]);
  });

  it('of upper PDUs has the side by its ports', () => {
    const tags = (source: number, destination: number) =>
      joined(
        hex('000c 0008'),
        new TextEncoder().encode('mbrtu\0\0\0'),
        hex('0018 0004 00000003'),
        hex('0019 0004 0000'),
        [source >> 8, source & 255],
        hex('001a 0004 0000'),
        [destination >> 8, destination & 255],
        hex('0000 0000'),
      );
    const file = pcap([{ bytes: joined(tags(49152, 502), REQUEST) }, { bytes: joined(tags(502, 49152), REPLY) }], {
      link: 252,
    });
    expect(found(file)).toEqual([
      [text(REQUEST), 'rtu', 'request', [1]],
      [text(REPLY), 'rtu', 'response', [2]],
    ]);
  });
});

describe('what tshark prints', () => {
  const request = '00:01:00:00:00:06:01:03:00:6b:00:03';
  const reply = '00:01:00:00:00:09:01:03:06:02:2b:00:00:00:64';
  const packet = (
    number: number,
    time: string,
    from: string,
    to: string,
    ports: readonly string[],
    payload: string,
  ) => ({
    _source: {
      layers: {
        frame: { 'frame.number': String(number), 'frame.time_epoch': time },
        ip: { 'ip.src': from, 'ip.dst': to },
        tcp: { 'tcp.srcport': ports[0], 'tcp.dstport': ports[1], 'tcp.seq_raw': '1', 'tcp.payload': payload },
      },
    },
  });
  const expected = [
    { time: 1_700_000_000_100_000, side: 'request', from: '192.0.2.1:49152', place: { kind: 'packet', numbers: [3] } },
    { time: 1_700_000_000_120_000, side: 'response', from: '192.0.2.2:502', place: { kind: 'packet', numbers: [5] } },
  ];

  it('as JSON', () => {
    const json = JSON.stringify([
      packet(3, '1700000000.100000000', '192.0.2.1', '192.0.2.2', ['49152', '502'], request),
      packet(5, '1700000000.120000000', '192.0.2.2', '192.0.2.1', ['502', '49152'], reply),
    ]);
    const { format, records } = readCapture(new TextEncoder().encode(json));
    expect(format).toBe('tshark-json');
    expect(Array.from(records)).toMatchObject(expected);
  });

  it('as fields under their names', () => {
    const fields = [
      'frame.number\tframe.time_epoch\tip.src\tip.dst\ttcp.srcport\ttcp.dstport\ttcp.payload',
      `3\t1700000000.100000000\t192.0.2.1\t192.0.2.2\t49152\t502\t${request.replaceAll(':', '')}`,
      `5\t1700000000.120000000\t192.0.2.2\t192.0.2.1\t502\t49152\t${reply.replaceAll(':', '')}`,
    ].join('\n');
    const { format, records } = readCapture(new TextEncoder().encode(fields));
    expect(format).toBe('tshark-fields');
    expect(Array.from(records)).toMatchObject(expected);
  });

  it.each([',', ';', '|'])('as fields under their names, in quotes and with “%s” between them', (separator) => {
    const rows = [
      [
        '3',
        'Nov 14, 2023 22:13:20.100000000 UTC',
        '192.0.2.1',
        '192.0.2.2',
        '49152',
        '502',
        request.replaceAll(':', ''),
      ],
      ['5', 'Nov 14, 2023 22:13:20.120000000 UTC', '192.0.2.2', '192.0.2.1', '502', '49152', reply.replaceAll(':', '')],
    ];
    const fields = [
      ['frame.number', 'frame.time', 'ip.src', 'ip.dst', 'tcp.srcport', 'tcp.dstport', 'tcp.payload'].join(separator),
      ...rows.map((cells) => cells.map((cell) => `"${cell}"`).join(separator)),
    ].join('\n');
    const { format, records } = readCapture(new TextEncoder().encode(fields));
    expect(format).toBe('tshark-fields');
    expect(Array.from(records)).toMatchObject(expected);
  });

  it('as a stream that is followed, whose one side is indented by a tab', () => {
    const [asked, answered] = [request.replaceAll(':', ''), reply.replaceAll(':', '')];
    const { records } = readCapture(new TextEncoder().encode(`${asked}\n\t${answered}\n${asked}\n\t${answered}\n`));
    expect(Array.from(records, ({ side }) => side)).toEqual(['request', 'response', 'request', 'response']);
  });

  it('as fields without names: payload, addresses, time and ports are seen in the cells', () => {
    const fields = [
      `1700000000.100000000\t192.0.2.1\t49152\t192.0.2.2\t502\t${request}`,
      `1700000000.120000000\t192.0.2.2\t502\t192.0.2.1\t49152\t${reply}`,
    ].join('\n');
    const { format, records } = readCapture(new TextEncoder().encode(fields));
    expect(format).toBe('tshark-fields');
    expect(Array.from(records)).toMatchObject(expected.map(({ place: _, ...others }) => others));
  });
});
