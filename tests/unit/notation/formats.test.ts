import { expect, test } from 'vitest';
import { type ByteFormat, byteFormats, readBytes, writeBytes } from '../../../src/notation/index.ts';

const frame = Uint8Array.of(0x01, 0xab, 0x00);

const WRITTEN: Readonly<Record<ByteFormat, string>> = {
  spaced: '01 AB 00',
  arduino: 'const byte frame[] = { 0x01, 0xAB, 0x00 };',
  csharp: 'byte[] frame = { 0x01, 0xAB, 0x00 };',
  python: 'frame = bytes([0x01, 0xAB, 0x00])',
  javascript: 'const frame = Uint8Array.of(0x01, 0xAB, 0x00);',
  plain: '01AB00',
  list: '0x01, 0xAB, 0x00',
  c: 'const uint8_t frame[3] = { 0x01, 0xAB, 0x00 };',
  st: 'Frame : ARRAY[0..2] OF BYTE := [16#01, 16#AB, 16#00];',
  brackets: '[0x01][0xAB][0x00]',
  escapes: '\\x01\\xAB\\x00',
  decimal: '1, 171, 0',
};

test.each(Object.keys(byteFormats) as ByteFormat[])('bytes as %s', (format) => {
  expect(writeBytes(frame, format)).toBe(WRITTEN[format]);
});

const NAMED: Readonly<Record<string, string>> = {
  c: 'const uint8_t write_p0683_30_hz[3] = { 0x01, 0xAB, 0x00 };',
  arduino: 'const byte writeP0683_30Hz[] = { 0x01, 0xAB, 0x00 };',
  csharp: 'byte[] writeP0683_30Hz = { 0x01, 0xAB, 0x00 };',
  st: 'WriteP0683_30Hz : ARRAY[0..2] OF BYTE := [16#01, 16#AB, 16#00];',
  python: 'write_p0683_30_hz = bytes([0x01, 0xAB, 0x00])',
  javascript: 'const writeP0683_30Hz = Uint8Array.of(0x01, 0xAB, 0x00);',
};

test.each(Object.keys(NAMED) as ByteFormat[])('a name in %s, and the bytes are read back', (format) => {
  const text = writeBytes(frame, format, ['write', 'p0683', '30', 'hz']);
  expect(text).toBe(NAMED[format]);
  expect(readBytes(text).bytes).toEqual(frame);
});
