import { describe, expect, it } from 'vitest';
import { findChecksums, MOST_SEARCHED } from '../../../src/diagnosis/index.ts';
import { hex } from '../modbus/frames.ts';

const frame = hex('21 03 03 E7 00 04');
const found = (bytes: Uint8Array, claimed?: string) =>
  findChecksums(bytes, claimed === undefined ? undefined : hex(claimed));

describe('a claimed value', () => {
  it.each([
    // As the calculator prints them.
    ['1AF3', { algorithm: 'CRC-16/MODBUS', lowFirst: false, from: 0, to: 6 }],
    ['CA7A', { algorithm: 'CRC-16/KERMIT', lowFirst: true, from: 0, to: 6 }],
    ['C278', { algorithm: 'CRC-16/DNP', lowFirst: true, from: 0, to: 6 }],
    ['9ACD', { algorithm: 'Sick', lowFirst: true, from: 0, to: 6 }],
    ['83E7A032', { algorithm: 'CRC-32/ISO-HDLC', lowFirst: false, from: 0, to: 6 }],
    ['32A0E783', { algorithm: 'CRC-32/ISO-HDLC', lowFirst: true, from: 0, to: 6 }],
    ['12', { algorithm: 'SUM-8', from: 0, to: 6 }],
  ])('%s', (claimed, match) => {
    expect(found(frame, claimed)[0]).toMatchObject(match);
  });

  it('of fewer bytes than there are', () => {
    // 02 07 has the CRC 41 12 on the wire (SL 6.2); it stands behind two bytes that it does not cover.
    expect(found(hex('AA 55 02 07'), '41 12')[0]).toMatchObject({
      algorithm: 'CRC-16/MODBUS',
      lowFirst: true,
      from: 2,
      to: 4,
    });
    expect(found(hex('02 07 41 12'), '1241')[0]).toMatchObject({ algorithm: 'CRC-16/MODBUS', from: 0, to: 2 });
  });

  it('of a register that began with another value', () => {
    // With 00FF in the register instead of FFFF, bit by bit.
    const match = { algorithm: 'CRC-16/MODBUS', start: 0x00ff, lowFirst: false };
    expect(found(hex('02 07'), '5201')).toEqual([expect.objectContaining(match)]);
  });

  it('that nothing has', () => {
    expect(found(hex('01 03 00 00 00 01'), '12345678')).toEqual([]);
    expect(found(hex('01 03'), '123456')).toEqual([]);
    expect(found(hex(''), 'FFFF')).toEqual([]);
    expect(found(new Uint8Array(MOST_SEARCHED + 1), '0000')).toEqual([]);
  });
});

describe('a value at the end of the bytes', () => {
  it.each([
    ['02 07 41 12', { algorithm: 'CRC-16/MODBUS', lowFirst: true, from: 0, to: 2, at: 2 }],
    ['02 07 12 41', { algorithm: 'CRC-16/MODBUS', lowFirst: false, from: 0, to: 2, at: 2 }],
    ['0A 01 04 A1 00 01 4F', { algorithm: 'LRC', from: 0, to: 6, at: 6 }],
    ['31 32 33 34 35 36 37 38 39 26 39 F4 CB', { algorithm: 'CRC-32/ISO-HDLC', lowFirst: true, from: 0, to: 9, at: 9 }],
  ])('%s', (text, match) => {
    expect(found(hex(text))[0]).toMatchObject(match);
  });
});

it('the CRC of the characters instead of the bytes', () => {
  // The register after the 17 characters "01 03 00 00 00 01", by the bit-by-bit program of SL 6.2.
  const register = [...'01 03 00 00 00 01'].reduce((before, one) => {
    let crc = before ^ one.charCodeAt(0);
    for (let bit = 0; bit < 8; bit++) crc = crc & 1 ? (crc >> 1) ^ 0xa001 : crc >> 1;
    return crc;
  }, 0xffff);
  const claimed = register.toString(16).padStart(4, '0');
  expect(found(hex('01 03 00 00 00 01'), claimed)).toEqual(
    expect.arrayContaining([expect.objectContaining({ algorithm: 'CRC-16/MODBUS', text: '01 03 00 00 00 01' })]),
  );
});

it('says how often chance would do', () => {
  const [match] = found(frame, '1AF3');
  expect(match!.chance).toBeGreaterThan(0);
  expect(match!.chance).toBeLessThan(0.05);
});
