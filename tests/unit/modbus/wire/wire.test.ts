import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import {
  characterBits,
  edgesOf,
  fromHex,
  type LineFrame,
  lineOf,
  parityBit,
  type Receiver,
  readSerialFormat,
  receive,
  type SerialFormat,
  serialFormats,
} from '../../../../src/modbus/index.ts';

const format = (name: string): SerialFormat => readSerialFormat(name)!;
const bytesOf = (hex: string) => fromHex(hex)!;
const bitsOf = (value: number, name: string) =>
  characterBits(value, format(name))
    .map(({ level }) => level)
    .join('');
const lineWith = (hex: string, name: string, more: Partial<LineFrame> = {}) =>
  lineOf([{ bytes: bytesOf(hex), ...more }], format(name), { lead: 10, silence: 38.5, delay: 0 });
/** What a receiver reads of bytes sent one behind the other: `E9 parity`. */
const readOf = (hex: string, sent: string, receiver: Partial<Receiver> = {}) =>
  receive(edgesOf(lineWith(hex, sent)), { format: format(sent), bit: 1, ...receiver }).map(({ value, errors }) =>
    [value.toString(16).toUpperCase().padStart(2, '0'), ...errors].join(' '),
  );

describe('the bits of a character', () => {
  test('go start, data from the least significant bit, parity, stop (SL 2.5.1)', () => {
    // 0xC5 = 1100 0101, the example of the parity bit in SL 2.5.1: four ones.
    expect(bitsOf(0xc5, '8E1')).toBe('0' + '10100011' + '0' + '1');
    expect(bitsOf(0xc5, '8O1')).toBe('0' + '10100011' + '1' + '1');
    expect(bitsOf(0xc5, '8N1')).toBe('0' + '10100011' + '1');
    expect(bitsOf(0xc5, '8N2')).toBe('0' + '10100011' + '11');
    // ":" = 011 1010, four ones in seven bits.
    expect(bitsOf(0x3a, '7E1')).toBe('0' + '0101110' + '0' + '1');
    expect(bitsOf(0x3a, '7O1')).toBe('0' + '0101110' + '1' + '1');
    expect(bitsOf(0x3a, '7N2')).toBe('0' + '0101110' + '11');
    expect(characterBits(0x06, format('7E2')).map(({ kind }) => kind)).toEqual([
      'start',
      ...Array(7).fill('data'),
      'parity',
      'stop',
      'stop',
    ]);
  });

  test('of seven data bits leave the eighth out, of the parity too', () => {
    expect(bitsOf(0xc5, '7E1')).toBe('0' + '1010001' + '1' + '1');
    expect(parityBit(0x80, format('7E1'))).toBe(0);
    expect(parityBit(0x80, format('8E1'))).toBe(1);
  });
});

describe('frames on a line', () => {
  test('stand between their silences, a gap inside and the delay of the device between them', () => {
    const request = bytesOf('0102');
    const { characters, quiets, frames, end } = lineOf(
      [{ bytes: request, gap: { after: 1, length: 20 } }, { bytes: bytesOf('03') }],
      format('8E1'),
      { lead: 11, silence: 38.5, delay: 100 },
    );
    expect(characters.map(({ frame, index, start, end: to }) => [frame, index, start, to])).toEqual([
      [0, 0, 49.5, 60.5],
      [0, 1, 80.5, 91.5],
      [1, 0, 191.5, 202.5],
    ]);
    expect(quiets.map(({ kind, frame, from, to }) => [kind, frame, from, to])).toEqual([
      ['before', 0, 0, 49.5],
      ['inside', 0, 60.5, 80.5],
      ['between', 0, 91.5, 191.5],
      ['after', 1, 202.5, 252],
    ]);
    expect(frames).toEqual([
      { from: 49.5, to: 91.5 },
      { from: 191.5, to: 202.5 },
    ]);
    expect(end).toBe(252);
  });

  test('keep their silence where the device is said to be faster', () => {
    const line = lineOf([{ bytes: bytesOf('01') }, { bytes: bytesOf('02') }], format('8E1'), {
      lead: 0,
      silence: 38.5,
      delay: 5,
    });
    expect(line.quiets[1]).toEqual({ kind: 'between', frame: 0, from: 49.5, to: 88 });
  });

  test('change the level where the bits change', () => {
    // 8N1, 0x0F: start 0, 1111 0000, stop 1.
    expect(edgesOf(lineWith('0F', '8N1'))).toEqual([48.5, 49.5, 53.5, 57.5]);
  });
});

describe('a receiver', () => {
  test('set as the sender reads what was sent, in every format', () => {
    fc.assert(
      fc.property(
        fc.uint8Array({ maxLength: 40 }),
        fc.constantFrom(...serialFormats),
        fc.record({ after: fc.nat(40), length: fc.double({ min: 0, max: 500, noNaN: true }) }),
        (bytes, each, gap) => {
          const line = lineOf([{ bytes, gap }], each, { lead: 3, silence: 0, delay: 0 });
          const most = each.dataBits === 7 ? 0x7f : 0xff;
          const received = receive(edgesOf(line), { format: each, bit: 1 });
          expect(received.map(({ value }) => value)).toEqual(Array.from(bytes, (value) => value & most));
          expect(received.flatMap(({ errors }) => errors)).toEqual([]);
        },
      ),
    );
  });

  test('of the wrong parity finds each byte wrong', () => {
    expect(readOf('0103', '8E1', { format: format('8O1') })).toEqual(['01 parity', '03 parity']);
  });

  test('without parity takes the parity bit for the stop bit', () => {
    // 01 has one 1, so that its parity bit is 1 and passes for a stop bit; that of 03 is 0.
    expect(readOf('010301', '8E1', { format: format('8N1') })).toEqual(['01', '03 framing', '01']);
  });

  test('with parity takes the stop bit for the parity, and the next start bit for the stop bit', () => {
    // In the last byte a stop bit of 1 is the parity of 01, and the idle line its stop bit.
    expect(readOf('01', '8N1', { format: format('8E1') })).toEqual(['01']);
    expect(readOf('03', '8N1', { format: format('8E1') })).toEqual(['03 parity']);
    // 0 10000000 1 | 0 11000000 1: the stop bit is looked at in the next start bit.
    expect(readOf('0103', '8N1', { format: format('8E1') })[0]).toBe('01 framing');
    // A second stop bit leaves room for the parity.
    expect(readOf('0103', '8N2', { format: format('8E1') })).toEqual(['01', '03 parity']);
  });

  test('of seven data bits takes the eighth for the parity', () => {
    // 8N1 into 7E1: bit 7 is 0, which is the even parity of 03 and the odd one of 01.
    expect(readOf('03', '8N1', { format: format('7E1') })).toEqual(['03']);
    expect(readOf('01', '8N1', { format: format('7E1') })).toEqual(['01 parity']);
  });

  test('at twice the speed looks at each bit twice', () => {
    // 0 10000000 1 0 1: looked at every half bit, 00 11 00 00 0|0, so that data are 0,1,1,0,0,0,0,0, and the stop bit is 0.
    expect(readOf('01', '8N1', { bit: 0.5 })[0]).toBe('06 framing');
    // 0 10101010 1: 00 11 00 11 00 are start, 01100110 and a stop bit of 0.
    expect(readOf('55', '8N1', { bit: 0.5 })[0]).toBe('66 framing');
  });

  test('at half the speed looks where every second bit begins, and takes that bit', () => {
    // 0 11111111 1: the start bit is over by the middle of what should be one, so that all of it is a disturbance.
    expect(readOf('FF', '8N1', { bit: 2 })).toEqual([]);
    // 0 00000000 1 and then idle: looked at when 1, 3, 5, 7 and 9 bits have passed, and 9 are start and data.
    expect(readOf('00', '8N1', { bit: 2 })).toEqual(['F8']);
  });

  test('with its wires swapped takes the idle line for a break, and bits for their opposites', () => {
    // 8N1, 0x00 seen inverted: 1 while sent, so that the fall is at its stop bit, and the line stays down.
    expect(readOf('00', '8N1', { inverted: true })).toEqual(['00 break']);
    // 0 01010101 1 seen inverted: 1 10101010 0; the first fall is after the first data bit of 1.
    expect(readOf('AA', '8N1', { inverted: true })[0]).toBe('15 framing');
  });

  test('never reads more characters than the line has falls', () => {
    fc.assert(
      fc.property(
        fc.uint8Array({ maxLength: 30 }),
        fc.constantFrom(...serialFormats),
        fc.constantFrom(...serialFormats),
        fc.double({ min: 0.0001, max: 5000, noNaN: true }),
        fc.boolean(),
        (bytes, sent, other, bit, inverted) => {
          const edges = edgesOf(lineOf([{ bytes }], sent, { lead: 3, silence: 30, delay: 0 }));
          const received = receive(edges, { format: other, bit, inverted });
          expect(received.length).toBeLessThanOrEqual(edges.length / 2);
          for (const [index, { start }] of received.entries()) {
            if (index > 0) expect(start).toBeGreaterThan(received[index - 1]!.end);
          }
        },
      ),
    );
  });
});
