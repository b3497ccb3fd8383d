import { describe, expect, it } from 'vitest';
import { readCapture } from '../../../src/captures/index.ts';
import {
  answers,
  asks,
  block,
  enhanced,
  ethernet,
  hex,
  interfaceBlock,
  ipv4,
  ipv6,
  joined,
  number,
  pcap,
  REPLY,
  REQUEST,
  section,
  tcp,
  udp,
} from './wire.ts';

const asked = ipv4(asks, tcp(asks, 1, REQUEST));
const answered = ipv4(answers, tcp(answers, 1, REPLY));

/** What a capture has of two records, in short. */
const shortly = (bytes: Uint8Array) => {
  const { format, records, problems } = readCapture(bytes);
  return {
    format,
    records: Array.from(records, ({ bytes, time, side, transport, from, to, place }) => ({
      bytes: Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join(''),
      time,
      side,
      transport,
      from,
      to,
      place,
    })),
    problems,
  };
};

const pair = (from: string, to: string, times: readonly (number | undefined)[] = [0, 0]) => [
  {
    bytes: '0001000000060103006b0003',
    time: times[0],
    side: 'request',
    transport: 'tcp',
    from,
    to,
    place: { kind: 'packet', numbers: [1] },
  },
  {
    bytes: '000100000009010306022b00000064',
    time: times[1],
    side: 'response',
    transport: 'tcp',
    from: to,
    to: from,
    place: { kind: 'packet', numbers: [2] },
  },
];
const V4 = pair('192.0.2.1:49152', '192.0.2.2:502');
const V6 = pair('[2001:db8::1]:49152', '[2001:db8::2]:502');

describe('pcap', () => {
  it.each([
    { isLittle: true, nanoseconds: false },
    { isLittle: false, nanoseconds: false },
    { isLittle: true, nanoseconds: true },
    { isLittle: false, nanoseconds: true },
  ])('is read by its magic number: %o', ({ isLittle, nanoseconds }) => {
    const fraction = nanoseconds ? 250_000_999 : 250_000;
    const file = pcap(
      [
        { bytes: ethernet(asked), seconds: 1_700_000_000, fraction },
        { bytes: ethernet(answered), seconds: 1_700_000_001, fraction },
      ],
      { isLittle, nanoseconds },
    );
    const times = [1_700_000_000_250_000, 1_700_000_001_250_000];
    expect(shortly(file)).toEqual({
      format: 'pcap',
      records: pair('192.0.2.1:49152', '192.0.2.2:502', times),
      problems: [],
    });
  });

  it('may be cut off at its end', () => {
    const file = pcap([{ bytes: ethernet(asked) }, { bytes: ethernet(answered) }]);
    const cut = shortly(file.subarray(0, file.length - 5));
    expect(cut.records).toEqual(V4.slice(0, 1));
    expect(cut.problems).toEqual([{ code: 'cut-off', place: { kind: 'packet', numbers: [2] } }]);
  });
});

describe('pcapng', () => {
  it.each([true, false])('is read by its byte order (little: %s)', (isLittle) => {
    const file = joined(
      section(isLittle),
      interfaceBlock(1, [], isLittle),
      enhanced(ethernet(asked), 1_700_000_000_250_000n, 0, isLittle),
      enhanced(ethernet(answered), 1_700_000_001_250_000n, 0, isLittle),
    );
    const times = [1_700_000_000_250_000, 1_700_000_001_250_000];
    expect(shortly(file)).toEqual({
      format: 'pcapng',
      records: pair('192.0.2.1:49152', '192.0.2.2:502', times),
      problems: [],
    });
  });

  it.each([
    ['nanoseconds', [9, 0, 1, 0, 9, 0, 0, 0, 0, 0, 0, 0], 1_700_000_000_250_000_999n, 1_700_000_000_250_000],
    ['milliseconds', [9, 0, 1, 0, 3, 0, 0, 0, 0, 0, 0, 0], 1_700_000_000_250n, 1_700_000_000_250_000],
    ['powers of two', [9, 0, 1, 0, 0x8a, 0, 0, 0, 0, 0, 0, 0], 1_700_000_000n * 1024n + 512n, 1_700_000_000_500_000],
    ['picoseconds', [9, 0, 1, 0, 12, 0, 0, 0, 0, 0, 0, 0], 1_700_000_000_000_007n, 1_700_000_000],
    [
      'seconds of offset',
      [14, 0, 8, 0, 10, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0],
      1_700_000_000_000_000n,
      1_700_000_010_000_000,
    ],
  ])('has time stamps in %s', (_what, options, ticks, time) => {
    const file = joined(section(), interfaceBlock(1, options), enhanced(ethernet(asked), ticks));
    expect(readCapture(file).records[0]?.time).toBe(time);
  });

  it('has several sections, each with its own byte order and interfaces', () => {
    const file = joined(
      section(true),
      interfaceBlock(101),
      enhanced(asked, 0n),
      section(false),
      interfaceBlock(1, [], false),
      enhanced(ethernet(answered), 0n, 0, false),
    );
    expect(shortly(file)).toEqual({ format: 'pcapng', records: V4, problems: [] });
  });

  it('has simple packets without a time, old ones, and blocks that nobody knows', () => {
    const simple = ethernet(asked);
    const old = ethernet(answered);
    const file = joined(
      section(),
      interfaceBlock(1),
      block(0x0bad, hex('01 02 03 04')),
      block(3, joined(number(simple.length, 4, true), simple)),
      block(
        2,
        joined(
          [0, 0, 0, 0],
          number(0, 4, true),
          number(7, 4, true),
          number(old.length, 4, true),
          number(old.length, 4, true),
          old,
        ),
      ),
    );
    expect(shortly(file)).toEqual({
      format: 'pcapng',
      records: pair('192.0.2.1:49152', '192.0.2.2:502', [undefined, 7]),
      problems: [],
    });
  });

  it('names an interface that is not there, and goes on', () => {
    const file = joined(section(), interfaceBlock(1), enhanced(ethernet(asked), 0n, 5), enhanced(ethernet(asked), 0n));
    const { records, problems } = readCapture(file);
    expect(records[0]?.place).toEqual({ kind: 'packet', numbers: [2] });
    expect(problems).toEqual([{ code: 'interface-unknown', place: { kind: 'packet', numbers: [1] } }]);
  });
});

describe('links', () => {
  const cooked = (payload: Uint8Array) => joined(hex('0000 0001 0006 000000000000 0000 0800'), payload);
  const cooked2 = (payload: Uint8Array) => joined(hex('0800 0000 00000001 0001 00 06 0000000000000000'), payload);
  const cooked2Tagged = (payload: Uint8Array) =>
    joined(hex('8100 0000 00000001 0001 00 06 0000000000000000'), hex('0064 0800'), payload);
  it.each([
    ['Ethernet', 1, (payload: Uint8Array) => ethernet(payload)],
    ['Ethernet with a VLAN', 1, (payload: Uint8Array) => ethernet(payload, 0x0800, [0x81, 0x00, 0x00, 0x64])],
    [
      'Ethernet with two VLANs',
      1,
      (payload: Uint8Array) => ethernet(payload, 0x0800, [0x88, 0xa8, 0x00, 0x0a, 0x81, 0x00, 0x00, 0x64]),
    ],
    ['Ethernet with padding', 1, (payload: Uint8Array) => joined(ethernet(payload), new Uint8Array(6))],
    ['Linux cooked 1', 113, cooked],
    ['Linux cooked 2', 276, cooked2],
    ['Linux cooked 2 with a VLAN', 276, cooked2Tagged],
    ['raw IP', 101, (payload: Uint8Array) => payload],
    ['raw IPv4', 228, (payload: Uint8Array) => payload],
    ['loopback', 0, (payload: Uint8Array) => joined([2, 0, 0, 0], payload)],
    ['loopback, high byte first', 0, (payload: Uint8Array) => joined([0, 0, 0, 2], payload)],
    ['OpenBSD loopback', 108, (payload: Uint8Array) => joined([0, 0, 0, 2], payload)],
  ])('%s', (_name, link, wrap) => {
    const file = pcap([{ bytes: wrap(asked) }, { bytes: wrap(answered) }], { link });
    expect(shortly(file)).toEqual({ format: 'pcap', records: V4, problems: [] });
  });

  it.each([
    // RFC 2516, 4: version and type 1, session data, session, length; RFC 1661: protocol IPv4.
    ['PPPoE', 1, (payload: Uint8Array) => ethernet(joined([0x11, 0, 0, 1, 0, 54, 0x00, 0x21], payload), 0x8864)],
    ['PPP with its address', 9, (payload: Uint8Array) => joined([0xff, 0x03, 0x00, 0x21], payload)],
    ['PPP with a short protocol', 9, (payload: Uint8Array) => joined([0x21], payload)],
    // RFC 3032, 2.1: two labels, the last one says so.
    ['MPLS', 1, (payload: Uint8Array) => ethernet(joined([0, 1, 0x00, 64, 0, 2, 0x01, 64], payload), 0x8847)],
    ['PPI', 192, (payload: Uint8Array) => joined([0, 0, 8, 0, 1, 0, 0, 0], ethernet(payload))],
    // RFC 2784: no options, type IPv4. RFC 2890: with a key.
    ['GRE', 101, (payload: Uint8Array) => ipv4({}, joined([0, 0, 8, 0], payload), { protocol: 47 })],
    [
      'GRE with a key, bridged',
      101,
      (payload: Uint8Array) => ipv4({}, joined([0x20, 0, 0x65, 0x58, 0, 0, 0, 7], ethernet(payload)), { protocol: 47 }),
    ],
    ['IP in IP', 101, (payload: Uint8Array) => ipv4({}, payload, { protocol: 4 })],
    // RFC 7348, 5: flags with a network, network 1.
    [
      'VXLAN',
      101,
      (payload: Uint8Array) =>
        ipv4({}, udp({ from: 55555, to: 4789 }, joined([8, 0, 0, 0, 0, 0, 1, 0], ethernet(payload))), {
          protocol: 17,
        }),
    ],
  ])('IP in %s', (_name, link, wrap) => {
    const file = pcap([{ bytes: wrap(asked) }, { bytes: wrap(answered) }], { link });
    expect(shortly(file)).toEqual({ format: 'pcap', records: V4, problems: [] });
  });

  it('a pcap of a patched libpcap has eight more bytes before each packet', () => {
    const packet = ethernet(asked);
    const head = pcap([]);
    head.set([0x34, 0xcd, 0xb2, 0xa1]);
    const record = joined(number(0, 8, true), number(packet.length, 4, true), number(packet.length, 4, true));
    const file = joined(head, record, [1, 0, 0, 0, 0, 0, 0, 0], packet);
    expect(shortly(file)).toEqual({ format: 'pcap', records: [V4[0]], problems: [] });
  });

  it('a pcap that ends in its own header is one', () => {
    const { format, problems } = readCapture(pcap([]).subarray(0, 23));
    expect(format).toBe('pcap');
    expect(problems).toEqual([{ code: 'cut-off', place: { kind: 'bytes', from: 0, to: 23 } }]);
  });

  it('says which links it does not know', () => {
    const { records, problems } = readCapture(pcap([{ bytes: ethernet(asked) }], { link: 105 }));
    expect(records).toHaveLength(0);
    expect(problems).toEqual([
      { code: 'link-unknown', link: 105, packets: 1 },
      { code: 'no-modbus', packets: 1 },
    ]);
  });
});

describe('IP', () => {
  it('IPv4 with options', () => {
    const wrap = (ip: Uint8Array) => ({ bytes: ethernet(ip) });
    const options = [0x94, 0x04, 0x00, 0x00];
    const file = pcap([
      wrap(ipv4(asks, tcp(asks, 1, REQUEST), { options })),
      wrap(ipv4(answers, tcp(answers, 1, REPLY), { options })),
    ]);
    expect(shortly(file).records).toEqual(V4);
  });

  it.each([
    ['in order', [0, 1]],
    ['in the other order', [1, 0]],
  ])('IPv4 in fragments, %s', (_name, order) => {
    const segment = tcp(asks, 1, REQUEST);
    const pieces = [
      ipv4(asks, segment.subarray(0, 24), { id: 9, fragment: 0x2000 }),
      ipv4(asks, segment.subarray(24), { id: 9, fragment: 3 }),
    ];
    const file = pcap(order.map((index) => ({ bytes: ethernet(pieces[index] as Uint8Array) })));
    const [record] = shortly(file).records;
    expect(record).toMatchObject({ bytes: V4[0]?.bytes, from: '192.0.2.1:49152' });
  });

  it('IPv6, with extension headers and in fragments', () => {
    const request = tcp(asks, 1, REQUEST);
    const options = hex('06 00 00 00 00 00 00 00');
    const plain = pcap([
      { bytes: ethernet(ipv6(true, request, 60, options), 0x86dd) },
      { bytes: ethernet(ipv6(false, tcp(answers, 1, REPLY)), 0x86dd) },
    ]);
    expect(shortly(plain).records).toEqual(V6);
    const fragments = pcap([
      { bytes: ethernet(ipv6(true, request.subarray(0, 24), 44, hex('06 00 0001 00000007')), 0x86dd) },
      { bytes: ethernet(ipv6(true, request.subarray(24), 44, hex('06 00 0018 00000007')), 0x86dd) },
    ]);
    expect(shortly(fragments).records).toMatchObject([{ bytes: V6[0]?.bytes, from: '[2001:db8::1]:49152' }]);
  });

  it('UDP, several ADUs in a datagram', () => {
    const file = pcap([
      { bytes: ethernet(ipv4(asks, udp(asks, joined(REQUEST, REQUEST)), { protocol: 17 })) },
      { bytes: ethernet(ipv4(answers, udp(answers, REPLY), { protocol: 17 })) },
    ]);
    expect(shortly(file).records.map(({ bytes, side }) => [bytes, side])).toEqual([
      [V4[0]?.bytes, 'request'],
      [V4[0]?.bytes, 'request'],
      [V4[1]?.bytes, 'response'],
    ]);
  });
});

describe('other files', () => {
  it('a gzipped file is to be unpacked before', () => {
    expect(readCapture(hex('1f 8b 08 00'))).toMatchObject({ format: '', problems: [{ code: 'gzipped' }] });
  });

  it('a text is read as logs are', () => {
    const text = '10:00:00.000 Tx: 01 03 00 6B 00 03 74 17\n10:00:00.020 Rx: 01 03 06 02 2B 00 00 00 64 05 7A\n';
    expect(shortly(new TextEncoder().encode(text))).toMatchObject({
      format: 'text',
      records: [
        {
          bytes: '0103006b00037417',
          side: 'request',
          transport: 'rtu',
          time: 0,
          place: { kind: 'text', from: 17, to: 40 },
        },
        { bytes: '010306022b00000064057a', side: 'response', transport: 'rtu', time: 20_000 },
      ],
      problems: [],
    });
  });

  it('raw bytes are split', () => {
    const file = hex('01 03 00 6B 00 03 74 17 01 03 06 02 2B 00 00 00 64 05 7A');
    expect(shortly(file)).toMatchObject({
      format: 'bytes',
      records: [
        { bytes: '0103006b00037417', side: 'request', place: { kind: 'bytes', from: 0, to: 8 } },
        { bytes: '010306022b00000064057a', side: 'response', place: { kind: 'bytes', from: 8, to: 19 } },
      ],
    });
  });
});
