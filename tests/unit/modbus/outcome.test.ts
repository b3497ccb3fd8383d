import { describe, expect, test } from 'vitest';
import { type Direction, decodeFrame, type Transport } from '../../../src/modbus/index.ts';
import { characters, encodedAgain, expectEveryByteInOneSpan, hex, isFlagged, said, saidWhere } from './frames.ts';

const read = (bytes: Uint8Array, transport: Transport, direction: Direction) => {
  const reading = decodeFrame(bytes, { transport, direction });
  expectEveryByteInOneSpan(reading, bytes.length);
  expect(encodedAgain(reading)).toBe(Buffer.from(bytes).toString('hex').toUpperCase());
  return reading;
};

interface Growing {
  readonly what: string;
  readonly direction: Direction;
  readonly frame: string;
  /** Missing bytes after none, after one, and so on. While no byte tells the length, the least there can be. */
  readonly missing: readonly number[];
}

const rtu: readonly Growing[] = [
  {
    what: '03 asked',
    direction: 'request',
    frame: '11 03 006B 0003 7687',
    missing: [4, 3, 6, 5, 4, 3, 2, 1],
  },
  {
    what: '03 answered: the byte count tells',
    direction: 'response',
    frame: '11 03 06 AE41 5652 4340 49AD',
    missing: [4, 3, 3, 8, 7, 6, 5, 4, 3, 2, 1],
  },
  {
    what: '10 asked: the byte count tells',
    direction: 'request',
    frame: '11 10 0001 0002 04 000A 0102 C6F0',
    missing: [4, 3, 7, 6, 5, 4, 3, 6, 5, 4, 3, 2, 1],
  },
  {
    what: '16 answered: ten bytes, not eight',
    direction: 'response',
    frame: '11 16 0004 00F2 0025 66E2',
    missing: [4, 3, 8, 7, 6, 5, 4, 3, 2, 1],
  },
  {
    what: 'an exception',
    direction: 'response',
    frame: '11 83 02 C134',
    missing: [4, 3, 3, 2, 1],
  },
  {
    what: '0B asked: nothing but its function code',
    direction: 'request',
    frame: '11 0B 4C27',
    missing: [4, 3, 2, 1],
  },
];

describe.each(rtu)('RTU, $what', ({ direction, frame, missing }) => {
  const bytes = hex(frame);

  test.each(missing.map((expected, there) => ({ there, expected })))('$there bytes: $expected missing', (one) => {
    const { outcome, problems } = read(bytes.subarray(0, one.there), 'rtu', direction);
    expect(outcome).toEqual({ kind: 'short', missing: one.expected });
    expect(one.expected).toBeLessThanOrEqual(bytes.length - one.there);
    expect(problems).toMatchObject([{ code: 'frame-short', severity: 'error', missing: one.expected }]);
  });

  test('all of them: whole', () => {
    expect(missing).toHaveLength(bytes.length);
    const { outcome, problems } = read(bytes, 'rtu', direction);
    expect(outcome).toEqual({ kind: 'whole' });
    expect(problems).toEqual([]);
  });

  test.each([1, 2, 3])('followed by %i bytes 00, which leave the CRC at zero: extra', (more) => {
    const { outcome, forced } = read(Uint8Array.of(...bytes, ...new Array<number>(more).fill(0)), 'rtu', direction);
    expect(outcome).toEqual({ kind: 'extra', bytes: more });
    expect(forced).toEqual({ after: '00'.repeat(more) });
  });

  test('twice in one buffer: the second is left over', () => {
    const { outcome, problems } = read(Uint8Array.of(...bytes, ...bytes), 'rtu', direction);
    expect(outcome).toEqual({ kind: 'extra', bytes: bytes.length });
    expect(problems).toMatchObject([{ code: 'frame-extra', span: { from: bytes.length, to: 2 * bytes.length } }]);
  });
});

describe('the CRC holds at the end: a length is wrong, not the CRC', () => {
  test('a byte count too small', () => {
    const reading = read(hex('11 03 04 AE41 5652 4340 6A6D'), 'rtu', 'response');
    expect(reading.outcome).toEqual({ kind: 'whole' });
    expect(saidWhere(reading)).toEqual(['error count-wrong 2-3', 'error pdu-rest 7-9']);
    expect(reading.problems[0]).toMatchObject({ got: 4, expected: 6 });
  });
  test('a byte count too large', () => {
    const reading = read(hex('11 03 08 AE41 5652 4340 A66D'), 'rtu', 'response');
    expect(reading.outcome).toEqual({ kind: 'whole' });
    expect(saidWhere(reading)).toEqual(['error count-wrong 2-3', 'error pdu-short 3-9']);
    expect(reading.problems[0]).toMatchObject({ got: 8, expected: 6 });
  });
});

describe('TCP: the length field and the fields are two witnesses', () => {
  test('both agree, and bytes are missing', () => {
    const frame = hex('0001 0000 0006 11 03 006B 0003');
    for (let there = 6; there < 12; there++) {
      expect(read(frame.subarray(0, there), 'tcp', 'request').outcome).toEqual({ kind: 'short', missing: 12 - there });
    }
    for (let there = 0; there < 6; there++) {
      // Nothing tells the length yet: a header and a function code are the least.
      expect(read(frame.subarray(0, there), 'tcp', 'request').outcome).toEqual({ kind: 'short', missing: 8 - there });
    }
  });
  test('the length is too large, yet the fields end with the bytes', () => {
    const reading = read(hex('0001 0000 0007 11 03 006B 0003'), 'tcp', 'request');
    expect(reading.outcome).toEqual({ kind: 'whole' });
    expect(saidWhere(reading)).toEqual(['error mbap-length-wrong 4-6']);
    expect(reading.problems[0]).toMatchObject({ got: 7, expected: 6 });
    expect(reading.forced).toEqual({ length: 7 });
  });
  test('the length is too small, yet the fields end with the bytes', () => {
    const reading = read(hex('0001 0000 0005 11 03 006B 0003'), 'tcp', 'request');
    expect(reading.outcome).toEqual({ kind: 'whole' });
    expect(saidWhere(reading)).toEqual(['error mbap-length-wrong 4-6']);
    expect(reading.fields).toEqual({ startAddress: 107, quantity: 3 });
  });
  test('the length ends the frame before its fields do', () => {
    const reading = read(hex('0001 0000 0004 11 03 006B'), 'tcp', 'request');
    expect(reading.outcome).toEqual({ kind: 'whole' });
    expect(said(reading)).toEqual(['error pdu-short']);
  });
  test('two frames in one buffer', () => {
    const one = '0001 0000 0006 11 03 006B 0003';
    const { outcome, forced } = read(hex(one + one), 'tcp', 'request');
    expect(outcome).toEqual({ kind: 'extra', bytes: 12 });
    expect(forced).toEqual({ after: '0001000000061103006B0003' });
  });
});

describe('ASCII, in characters', () => {
  const ask = (text: string) => read(characters(text), 'ascii', 'request');

  test('pairs of digits that are still missing, and CR LF', () => {
    // After an even number of digits; the least is `:`, a unit, a function code, the LRC and CR LF.
    const frame = ':1103006B00037E\r\n';
    const missing: readonly (readonly [there: number, missing: number])[] = [
      [0, 9],
      [1, 8],
      [3, 6],
      [5, 12],
      [7, 10],
      [9, 8],
      [11, 6],
      [13, 4],
      [15, 2],
      [16, 1],
    ];
    for (const [there, expected] of missing) {
      expect(ask(frame.slice(0, there)).outcome, frame.slice(0, there)).toEqual({ kind: 'short', missing: expected });
    }
    expect(ask(frame).outcome).toEqual({ kind: 'whole' });
  });

  test('without CR LF it is not there yet', () => {
    expect(said(ask(':1103006B00037E'))).toEqual(['error frame-short']);
  });
  test('LF alone ends it wrongly', () => {
    const reading = ask(':1103006B00037E\n');
    expect(saidWhere(reading)).toEqual(['error ascii-end 15-16']);
    expect(reading).toMatchObject({ outcome: { kind: 'whole' }, fields: { quantity: 3 }, forced: { end: '0A' } });
  });
  test('another delimiter in place of LF may have been agreed (AP 6.8.1)', () => {
    expect(saidWhere(ask(':1103006B00037E\r;'))).toEqual(['warning ascii-end 15-17']);
  });
  test('the start is missing, or not first', () => {
    const reading = ask('1103006B00037E\r\n');
    expect(said(reading)).toEqual(['error ascii-start']);
    expect(reading.fields).toEqual({ startAddress: 107, quantity: 3 });
    expect(saidWhere(ask('  :1103006B00037E\r\n'))).toEqual(['error ascii-start 0-3']);
  });
  test('a stray character is passed over', () => {
    const reading = ask(':1103 006B00037E\r\n');
    expect(saidWhere(reading)).toEqual(['error ascii-character 5-6']);
    expect(reading.fields).toEqual({ startAddress: 107, quantity: 3 });
  });
  test('lower case is read, with a warning (SL 2.5.2)', () => {
    const reading = ask(':1103006b00037e\r\n');
    expect(saidWhere(reading)).toEqual(['warning ascii-lower-case 5-9']);
    expect(reading.fields).toEqual({ startAddress: 107, quantity: 3 });
  });
  test('an odd digit', () => {
    const reading = ask(':1103006B00037E0\r\n');
    expect(said(reading)).toContain('error ascii-odd-digit');
    expect(reading.outcome).toEqual({ kind: 'whole' });
  });
  test('CR LF too early: wrong, for nothing more will come', () => {
    for (const text of [':\r\n', ':11\r\n', ':1103\r\n', ':1103006B7F\r\n']) {
      const reading = ask(text);
      expect(reading.outcome, text).toEqual({ kind: 'whole' });
      expect(said(reading), text).toContain('error pdu-short');
    }
  });
  test('bytes after the fields, with an LRC that holds and no line end: not a whole frame', () => {
    // The reply of function 15 ends before 01, and 4D is the LRC of all bytes before it.
    const reading = read(characters(':870F0B090008014D'), 'ascii', 'response');
    expect(said(reading)).toEqual(['error pdu-rest', 'error frame-short']);
    expect(reading.outcome).toEqual({ kind: 'short', missing: 2 });
  });
  test('two frames in one buffer', () => {
    const frame = ':1103006B00037E\r\n';
    expect(ask(frame + frame).outcome).toEqual({ kind: 'extra', bytes: 17 });
  });
});

test('a bare PDU ends where its fields do', () => {
  expect(read(hex('03 006B 00'), 'pdu', 'request').outcome).toEqual({ kind: 'short', missing: 1 });
  expect(read(hex('03 006B 0003'), 'pdu', 'request').outcome).toEqual({ kind: 'whole' });
  expect(read(hex('03 006B 0003 00'), 'pdu', 'request').outcome).toEqual({ kind: 'extra', bytes: 1 });
  expect(read(hex(''), 'pdu', 'request').outcome).toEqual({ kind: 'short', missing: 1 });
});

test('a frame without a length of its own takes what there is, and its CRC decides', () => {
  const frame = hex('11 41 0102 03');
  const reading = read(Uint8Array.of(...frame, 0x00, 0x00), 'rtu', 'request');
  expect(reading.outcome).toEqual({ kind: 'whole' });
  expect(isFlagged(reading)).toBe(true);
});

test('a bare PDU that is cut off is short and nothing else: more of it may come', () => {
  for (const bytes of ['03 00 6B 00', '10 00 01 00 02 04 00 0A', '03 06 02 2B']) {
    const direction = bytes === '03 06 02 2B' ? 'response' : 'request';
    const reading = decodeFrame(hex(bytes), { transport: 'pdu', direction });
    expect(reading.problems.map(({ code }) => code)).toEqual(['frame-short']);
  }
});
