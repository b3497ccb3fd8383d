import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { readCapture } from '../../../src/captures/index.ts';
import {
  ACK,
  answers,
  asks,
  type Ends,
  ethernet,
  hex,
  ipv4,
  joined,
  pcap,
  REPLY,
  REQUEST,
  SECOND_REQUEST,
  SYN,
  tcp,
} from './wire.ts';

interface Sent {
  readonly by?: Ends;
  readonly seq: number;
  readonly bytes?: Uint8Array;
  readonly flags?: number;
  readonly ack?: number;
}

const packets = (sent: readonly Sent[]) =>
  sent.map(({ by = asks, seq, bytes = new Uint8Array(), flags = ACK, ack = 0 }, index) => ({
    bytes: ethernet(ipv4(by, tcp(by, seq, bytes, { flags, ack }))),
    fraction: index,
  }));
const capture = (...sent: readonly Sent[]) => readCapture(pcap(packets(sent)));
const text = (bytes: Uint8Array) => Array.from(bytes, (byte) => byte.toString(16).padStart(2, '0')).join('');
const found = ({ records }: ReturnType<typeof readCapture>) =>
  Array.from(records, ({ bytes, side, place }) => [text(bytes), side, place.kind === 'packet' ? place.numbers : []]);
const ONE = text(REQUEST);
const TWO = text(SECOND_REQUEST);
const ANSWER = text(REPLY);
const THIRD = hex('00 03 00 00 00 06 01 03 00 6B 00 03');

describe('TCP', () => {
  it('several ADUs in a segment', () => {
    expect(found(capture({ seq: 1, bytes: joined(REQUEST, SECOND_REQUEST) }))).toEqual([
      [ONE, 'request', [1]],
      [TWO, 'request', [1]],
    ]);
  });

  it('an ADU over many segments, and the next one behind it', () => {
    const all = joined(REQUEST, SECOND_REQUEST);
    expect(
      found(
        capture(
          { seq: 100, bytes: all.subarray(0, 3) },
          { seq: 103, bytes: all.subarray(3, 9) },
          { seq: 109, bytes: all.subarray(9, 20) },
          { seq: 120, bytes: all.subarray(20) },
        ),
      ),
    ).toEqual([
      [ONE, 'request', [1, 2, 3]],
      [TWO, 'request', [3, 4]],
    ]);
  });

  it('leaves retransmissions out, whole and overlapping', () => {
    const all = joined(REQUEST, SECOND_REQUEST);
    const { records, problems } = capture(
      { seq: 1, bytes: REQUEST },
      { seq: 1, bytes: REQUEST },
      { seq: 1, bytes: all },
      { seq: 7, bytes: all.subarray(6) },
    );
    expect(Array.from(records, ({ bytes }) => text(bytes))).toEqual([ONE, TWO]);
    expect(problems).toEqual([]);
  });

  it('puts segments in order', () => {
    const all = joined(REQUEST, SECOND_REQUEST);
    const mixed = capture(
      { seq: 0, flags: SYN },
      { seq: 13, bytes: all.subarray(12) },
      { seq: 1, bytes: all.subarray(0, 12) },
    );
    // Each frame has the time of the packet that its end came in.
    expect(found(mixed)).toEqual([
      [TWO, 'request', [2]],
      [ONE, 'request', [3]],
    ]);
    expect(mixed.problems).toEqual([]);
  });

  it('goes on over the end of the sequence numbers', () => {
    const all = joined(REQUEST, SECOND_REQUEST);
    expect(found(capture({ seq: 0xfffffff8, bytes: all.subarray(0, 8) }, { seq: 0, bytes: all.subarray(8) }))).toEqual([
      [ONE, 'request', [1, 2]],
      [TWO, 'request', [2]],
    ]);
  });

  it('reports a segment that was lost, and goes on at the next MBAP', () => {
    const { records, problems } = capture(
      { seq: 1, bytes: REQUEST },
      { seq: 20, bytes: joined(SECOND_REQUEST.subarray(7), THIRD) },
      { by: answers, seq: 1, ack: 20 + 17, bytes: REPLY },
    );
    expect(Array.from(records, ({ bytes }) => text(bytes))).toEqual([ONE, text(THIRD), ANSWER]);
    expect(problems).toEqual([
      { code: 'segment-lost', place: { kind: 'packet', numbers: [2] }, missing: 7 },
      { code: 'joined', place: { kind: 'packet', numbers: [2] }, bytes: 5 },
    ]);
  });

  it('takes no bytes for a frame behind a hole that are not legal', () => {
    // Without their first byte, 01 03 00 00 00 02 00 00 would be an ADU of function 0.
    const stream = hex('00 00 00 00 00 06 01 03 00 00 00 02 00 00 00 00 00 06 01 03 00 00 00 01');
    const bytes = Array.from(stream, (_, at) => ({ seq: 1 + at, bytes: stream.subarray(at, at + 1) }));
    const { records } = capture({ seq: 0, flags: SYN }, ...bytes.slice(1));
    expect(Array.from(records, (record) => text(record.bytes))).toEqual([text(stream.subarray(12))]);
  });

  it('joins a stream in its middle', () => {
    expect(found(capture({ seq: 500, bytes: joined(REQUEST.subarray(4), SECOND_REQUEST) }))).toEqual([
      [TWO, 'request', [1]],
    ]);
  });

  it('says what a snapped packet has lost', () => {
    const whole = ethernet(ipv4(asks, tcp(asks, 1, joined(REQUEST, SECOND_REQUEST))));
    const file = pcap([
      { bytes: whole.subarray(0, whole.length - 6), wire: whole.length },
      { bytes: ethernet(ipv4(asks, tcp(asks, 25, THIRD))) },
    ]);
    const { records, problems } = readCapture(file);
    expect(Array.from(records, ({ bytes }) => text(bytes))).toEqual([ONE, text(THIRD)]);
    expect(problems).toEqual([{ code: 'packet-cut', place: { kind: 'packet', numbers: [1] }, missing: 6 }]);
  });

  it('tells the roles by the handshake, before the port', () => {
    const by: Ends = { ...asks, from: 502, to: 502 };
    const back: Ends = { ...answers, from: 502, to: 502 };
    expect(
      found(
        capture(
          { by, seq: 9, flags: SYN },
          { by: back, seq: 99, flags: SYN | ACK, ack: 10 },
          { by: back, seq: 100, bytes: REPLY },
          { by, seq: 10, bytes: REQUEST },
        ),
      ),
    ).toEqual([
      [ANSWER, 'response', [3]],
      [ONE, 'request', [4]],
    ]);
  });

  it('finds Modbus at other ports, with the roles by its structure', () => {
    const by: Ends = { ...asks, from: 40000, to: 10502 };
    const back: Ends = { ...answers, from: 10502, to: 40000 };
    expect(found(capture({ by: back, seq: 100, bytes: REPLY }, { by, seq: 10, bytes: REQUEST }))).toEqual([
      [ANSWER, 'response', [1]],
      [ONE, 'request', [2]],
    ]);
  });

  it('leaves other protocols at other ports alone', () => {
    const by: Ends = { ...asks, from: 40000, to: 80 };
    const http = new TextEncoder().encode('GET / HTTP/1.1\r\nHost: example\r\n\r\n');
    const { records, problems } = capture({ by, seq: 1, bytes: http });
    expect(records).toHaveLength(0);
    expect(problems).toEqual([{ code: 'no-modbus', packets: 1 }]);
  });

  it('does not take the beginning of an ADU for a serial frame whose CRC holds', () => {
    // FF FF 00 00 is transaction FFFF and protocol 0, and FF FF with its CRC.
    const adu = hex('FF FF 00 00 00 06 01 03 00 00 00 01');
    for (const cut of [4, 5, 6, 7]) {
      const { records } = capture(
        { seq: 0, flags: SYN },
        { seq: 1, bytes: adu.subarray(0, cut) },
        { seq: 1 + cut, bytes: adu.subarray(cut) },
      );
      expect(Array.from(records, ({ bytes, transport }) => [text(bytes), transport])).toEqual([[text(adu), 'tcp']]);
    }
  });

  it('reads RTU over TCP', () => {
    const by: Ends = { ...asks, from: 40000, to: 4001 };
    const back: Ends = { ...answers, from: 4001, to: 40000 };
    const request = hex('01 03 00 6B 00 03 74 17');
    const reply = hex('01 03 06 02 2B 00 00 00 64 05 7A');
    const { records } = capture(
      { by, seq: 1, bytes: request },
      { by: back, seq: 1, bytes: reply.subarray(0, 4) },
      { by: back, seq: 5, bytes: reply.subarray(4) },
    );
    expect(Array.from(records, ({ bytes, transport, side }) => [text(bytes), transport, side])).toEqual([
      [text(request), 'rtu', 'request'],
      [text(reply), 'rtu', 'response'],
    ]);
  });

  it.each([502, 4001])('reads RTU over TCP whose frames all come in pieces, port %i', (port) => {
    const by: Ends = { ...asks, from: 40000, to: port };
    const back: Ends = { ...answers, from: port, to: 40000 };
    const request = hex('01 03 00 6B 00 03 74 17');
    const reply = hex('01 03 06 02 2B 00 00 00 64 05 7A');
    const { records, problems } = capture(
      { by, seq: 1, bytes: request.subarray(0, 3) },
      { by, seq: 4, bytes: request.subarray(3) },
      { by: back, seq: 1, bytes: reply.subarray(0, 1) },
      { by: back, seq: 2, bytes: reply.subarray(1, 6) },
      { by: back, seq: 7, bytes: reply.subarray(6) },
    );
    expect(Array.from(records, ({ bytes, transport, side, place }) => [text(bytes), transport, side, place])).toEqual([
      [text(request), 'rtu', 'request', { kind: 'packet', numbers: [1, 2] }],
      [text(reply), 'rtu', 'response', { kind: 'packet', numbers: [3, 4, 5] }],
    ]);
    expect(problems).toEqual([]);
  });

  it('says that a connection is encrypted', () => {
    const by: Ends = { ...asks, from: 40000, to: 802 };
    // RFC 8446, 5.1: a record of a handshake.
    const { problems } = capture(
      { by, seq: 1, bytes: hex('16 03 01 00 05 01 00 00 01 00') },
      { by, seq: 11, bytes: hex('17 03 03 00 02 AA BB') },
    );
    expect(problems).toEqual([
      { code: 'encrypted', place: { kind: 'packet', numbers: [1] } },
      { code: 'no-modbus', packets: 2 },
    ]);
  });
});

describe('any segments', () => {
  /** Cuts of the ADUs of a stream into segments, and an order in which they come. */
  const cuts = fc.array(fc.integer({ min: 1, max: 20 }), { minLength: 1, maxLength: 30 });
  const adus = fc.array(
    fc
      .tuple(fc.nat(0xffff), fc.nat(0xffff), fc.integer({ min: 1, max: 125 }))
      .map(([transaction, address, quantity]) =>
        Uint8Array.of(transaction >> 8, transaction & 255, 0, 0, 0, 6, 1, 3, address >> 8, address & 255, 0, quantity),
      ),
    { minLength: 1, maxLength: 12 },
  );

  function segmentsOf(stream: Uint8Array, sizes: readonly number[]): Sent[] {
    const segments: Sent[] = [];
    for (let at = 0, index = 0; at < stream.length; index++) {
      const size = sizes[index % sizes.length] as number;
      segments.push({ seq: 1 + at, bytes: stream.subarray(at, at + size) });
      at += size;
    }
    return segments;
  }

  it('give all ADUs, in whatever order and however often they come', () => {
    fc.assert(
      fc.property(adus, cuts, fc.infiniteStream(fc.nat(1000)), (frames, sizes, order) => {
        const segments = segmentsOf(joined(...frames), sizes);
        const again = segments.flatMap((segment) =>
          (order.next().value as number) % 4 === 0 ? [segment, segment] : [segment],
        );
        const mixed = again
          .map((segment) => ({ segment, at: order.next().value as number }))
          .sort((a, b) => a.at - b.at)
          .map(({ segment }) => segment);
        const { records, problems } = capture({ seq: 0, flags: SYN }, ...mixed);
        expect(Array.from(records, ({ bytes }) => text(bytes)).sort()).toEqual(frames.map(text).sort());
        expect(problems).toEqual([]);
      }),
    );
  });

  it('never invent a frame: each is one of those that were sent, if some segments are lost', () => {
    fc.assert(
      fc.property(adus, cuts, fc.array(fc.nat(40), { maxLength: 4 }), (frames, sizes, lost) => {
        const sent = new Set(frames.map(text));
        const left = segmentsOf(joined(...frames), sizes).filter((_, index) => !lost.includes(index));
        const { records } = capture({ seq: 0, flags: SYN }, ...left);
        for (const { bytes } of Array.from(records)) expect(sent).toContain(text(bytes));
      }),
    );
  });

  it('never throw, whatever the bytes are', () => {
    const start = fc.constantFrom(
      pcap([{ bytes: ethernet(ipv4(asks, tcp(asks, 1, REQUEST))) }]),
      hex('0a0d0d0a 1c000000 4d3c2b1a 01000000 ffffffffffffffff 1c000000'),
    );
    fc.assert(
      fc.property(start, fc.uint8Array({ maxLength: 200 }), fc.nat(400), (file, noise, at) => {
        const damaged = joined(file.subarray(0, at), noise, file.subarray(at));
        const { records, problems } = readCapture(damaged);
        expect(Array.from(records).length).toBe(records.length);
        expect(problems.every(({ code }) => code !== '')).toBe(true);
      }),
    );
  });
});
