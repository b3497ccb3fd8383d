import { describe, expect, it } from 'vitest';
import { diagnose } from '../../../src/diagnosis/index.ts';
import { crc, crc16, crcCatalogue } from '../../../src/modbus/index.ts';
import { characters, hex } from '../modbus/frames.ts';
import { firstOf, repairsOf, spaced } from './findings.ts';

/** Read three holding registers of unit 17 from address 107; its CRC is 76 87. */
const BODY = '11 03 00 6B 00 03';
const WHOLE = '11 03 00 6B 00 03 76 87';
const rtu = { transport: 'rtu' } as const;

describe('the CRC’s two bytes', () => {
  it.each([
    ['swapped', `${BODY} 87 76`, { code: 'crc-byte-order', from: 6, to: 8, got: 0x7687, expected: 0x8776 }],
    ['absent', BODY, { code: 'crc-missing', zero: false, expected: 0x8776 }],
    ['zero', `${BODY} 00 00`, { code: 'crc-missing', zero: true, expected: 0x8776 }],
    ['the LRC', `${BODY} 7E`, { code: 'lrc-instead-of-crc', from: 6, to: 7, got: 0x7e, expected: 0x8776 }],
    ['a line end', `${BODY} 0D 0A`, { code: 'crc-is-something-else', as: 'line-end' }],
    ['an exception', `${BODY} 83 02`, { code: 'crc-is-something-else', as: 'exception' }],
    ['unwritten memory', `${BODY} FF FF`, { code: 'crc-is-something-else', as: 'ones' }],
    ['the number of bytes', `${BODY} 00 06`, { code: 'crc-is-something-else', as: 'length' }],
    // CRC-16/ARC, which differs in its start value alone: 76 9C by the catalogue's row.
    ['of a register that began with 0', `${BODY} 76 9C`, { code: 'crc-start-value', start: 0 }],
  ])('%s', (_, bytes, expected) => {
    const found = firstOf(bytes, rtu);
    expect(found).toMatchObject(expected);
    expect(repairsOf(found)[0]).toBe(WHOLE);
  });
});

const bytesOf = (value: number, swapped: boolean) => {
  const pair = [value & 0xff, value >>> 8];
  return spaced(Uint8Array.from(swapped ? pair.reverse() : pair));
};

describe('another algorithm of 16 bits', () => {
  const others = crcCatalogue.filter(({ width, name }) => width === 16 && name !== 'CRC-16/MODBUS');
  it.each(others.map((row) => [row.name, row] as const))('%s, in both orders', (name, row) => {
    const value = crc(row, hex(BODY));
    for (const swapped of [false, true]) {
      const found = firstOf(`${BODY} ${bytesOf(value, swapped)}`, rtu);
      // ARC is CRC-16/MODBUS with another start value, and is said to be that where its bytes are in order.
      if (name === 'CRC-16/ARC' && !swapped) expect(found).toMatchObject({ code: 'crc-start-value', start: 0 });
      else expect(found).toMatchObject({ code: 'crc-algorithm', algorithm: name, swapped });
      expect(repairsOf(found)[0]).toBe(WHOLE);
    }
  });

  it('finds CRC-32 in four bytes', () => {
    // zlib.crc32 of the body is 0xE3637F36.
    expect(firstOf(`${BODY} 36 7F 63 E3`, rtu)).toMatchObject({ code: 'crc-algorithm', algorithm: 'CRC-32/ISO-HDLC' });
  });

  it('finds a plain sum', () => {
    expect(firstOf(`${BODY} 82`, rtu)).toMatchObject({ code: 'crc-algorithm', algorithm: 'SUM-8' });
  });
});

describe('the CRC of the text', () => {
  it.each([
    '11 03 00 6B 00 03',
    '1103006B0003',
    '11 03 00 6b 00 03',
    '0x11 0x03 0x00 0x6B 0x00 0x03',
    '0x11, 0x03, 0x00, 0x6b, 0x00, 0x03',
    '11,03,00,6B,00,03',
    '11:03:00:6B:00:03',
    '11-03-00-6B-00-03',
    '17, 3, 0, 107, 0, 3',
    '\\x11\\x03\\x00\\x6b\\x00\\x03',
  ])('%s', (text) => {
    const value = crc16(characters(text));
    for (const swapped of [false, true]) {
      const found = firstOf(`${BODY} ${bytesOf(value, swapped)}`, rtu);
      expect(found).toMatchObject({ code: 'crc-of-text', text, swapped });
      expect(repairsOf(found)[0]).toBe(WHOLE);
    }
  });
});

describe('the CRC over other bytes', () => {
  it.each([
    ['without the unit', '03 00 6B 00 03', { over: 'part', first: 1, last: 6 }],
    ['without the last byte', '11 03 00 6B 00', { over: 'part', first: 0, last: 5 }],
    ['with room for itself', '11 03 00 6B 00 03 00 00', { over: 'with-checksum' }],
    ['with its length in front', '06 11 03 00 6B 00 03', { over: 'with-length' }],
    ['with an MBAP header', '00 00 00 00 00 06 11 03 00 6B 00 03', { over: 'with-mbap' }],
  ])('%s', (_, covered, expected) => {
    const found = firstOf(`${BODY} ${bytesOf(crc16(hex(covered)), false)}`, rtu);
    expect(found).toMatchObject({ code: 'crc-span', ...expected });
    expect(repairsOf(found)[0]).toBe(WHOLE);
  });
});

describe('the CRC of another frame', () => {
  it('of the request, on its reply', () => {
    const reply = '11 03 06 AE 41 56 52 43 40';
    const found = firstOf(`${reply} 76 87`, { ...rtu, request: WHOLE });
    expect(found).toMatchObject({ code: 'crc-of-other-frame', of: 'request' });
    expect(repairsOf(found)).toEqual([`${reply} 49 AD`]);
  });

  it('of the reply, on its request', () => {
    // 01 10 00 01 00 02 has 10 08.
    expect(firstOf('01 10 00 01 00 02 04 00 0A 01 02 10 08', rtu)).toMatchObject({
      code: 'crc-of-other-frame',
      of: 'reply',
    });
  });

  it('of a refusal, on the request', () => {
    // 01 83 02 has C0 F1.
    expect(firstOf('01 03 00 00 00 04 C0 F1', rtu)).toMatchObject({ code: 'crc-of-other-frame', of: 'exception' });
  });
});

describe('one byte', () => {
  it.each([
    [
      'a bit of the address',
      '11 03 00 7B 00 03 76 87',
      { code: 'bit-error', at: 3, bit: 4, got: 0x7b, expected: 0x6b },
    ],
    [
      'a bit of the function',
      '11 07 00 6B 00 03 76 87',
      { code: 'bit-error', at: 1, bit: 2, got: 0x07, expected: 0x03 },
    ],
    ['a bit of the CRC', '11 03 00 6B 00 03 76 97', { code: 'bit-error', at: 7, bit: 4, got: 0x97, expected: 0x87 }],
    ['the unit', '2A 03 00 6B 00 03 76 87', { code: 'byte-error', at: 0, got: 0x2a, expected: 0x11 }],
    ['the quantity', '11 03 00 6B 00 30 76 87', { code: 'byte-error', at: 5, got: 0x30, expected: 0x03 }],
  ])('%s', (_, bytes, expected) => {
    const found = firstOf(bytes, rtu);
    expect(found).toMatchObject(expected);
    expect(found).toMatchObject({ from: expected.at, to: expected.at + 1 });
    expect(repairsOf(found)[0]).toBe(WHOLE);
  });

  it('finds every bit of a frame', () => {
    const frame = hex('11 03 06 AE 41 56 52 43 40 49 AD');
    const missed = Array.from({ length: 88 }, (_, i) => i).filter((i) => {
      const damaged = frame.map((byte, at) => (at === i >> 3 ? byte ^ (1 << (i & 7)) : byte));
      const found = firstOf(spaced(damaged), rtu);
      return (
        found.code !== 'bit-error' ||
        found.at !== i >> 3 ||
        found.bit !== (i & 7) ||
        repairsOf(found)[0] !== spaced(frame)
      );
    });
    expect(missed).toEqual([]);
  });

  it('one too many in the middle', () => {
    const found = firstOf('11 03 06 AE 41 0D 56 52 43 40 49 AD', rtu);
    expect(found).toMatchObject({ code: 'byte-inserted', at: 5, got: 0x0d });
    expect(repairsOf(found)).toEqual(['11 03 06 AE 41 56 52 43 40 49 AD']);
  });

  it.each([
    ['the unit is lost, which the request tells', { ...rtu, request: WHOLE }],
    ['the unit is lost, which the CRC tells', rtu],
  ])('%s', (_, known) => {
    const found = firstOf('03 06 AE 41 56 52 43 40 49 AD', known);
    expect(found).toMatchObject({ code: 'byte-lost', at: 0, lost: 0x11 });
    expect(repairsOf(found)).toEqual(['11 03 06 AE 41 56 52 43 40 49 AD']);
  });

  it('swallowed on the way', () => {
    const found = firstOf('01 03 08 00 01 02 00 00 03 04 EC F5', rtu);
    expect(found).toMatchObject({ code: 'byte-lost', lost: 0x00 });
    expect(repairsOf(found)).toContain('01 03 08 00 00 01 02 00 00 03 04 EC F5');
  });
});

describe('the checksum of ASCII frames', () => {
  it('is wrong', () => {
    const found = firstOf(':1103006B00037D\r\n');
    expect(found).toMatchObject({ code: 'lrc-wrong', from: 13, to: 15, got: 0x7d, expected: 0x7e });
    expect(repairsOf(found)).toEqual([spaced(characters(':1103006B00037E\r\n'))]);
  });

  it('is missing', () => {
    const found = firstOf(':1103006B0003\r\n');
    expect(found).toMatchObject({ code: 'lrc-missing', expected: 0x7e });
    expect(repairsOf(found)).toEqual([spaced(characters(':1103006B00037E\r\n'))]);
  });

  it('is a CRC', () => {
    const found = firstOf(':1103006B00037687\r\n');
    expect(found).toMatchObject({ code: 'crc-instead-of-lrc', expected: 0x7e });
    expect(repairsOf(found)).toEqual([spaced(characters(':1103006B00037E\r\n'))]);
  });
});

it('beside a cause that is known it is not said that nothing is', () => {
  const codes = diagnose(hex('06 06 02 AC 10 00 E6 A1'), { transport: 'rtu' }).map(({ code }) => code);
  expect(codes).toEqual(['crc-wrong']);
});
