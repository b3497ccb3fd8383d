import { expect, test } from 'vitest';
import { type ByteFormat, byteFormats, writeBytes } from '../../../src/notation/index.ts';

const frame = Uint8Array.of(0x01, 0xab, 0x00);

const WRITTEN: Readonly<Record<ByteFormat, string>> = {
  spaced: '01 AB 00',
  plain: '01AB00',
  list: '0x01, 0xAB, 0x00',
  c: 'const uint8_t frame[3] = { 0x01, 0xAB, 0x00 };',
  st: '[16#01, 16#AB, 16#00]',
  brackets: '[0x01][0xAB][0x00]',
  escapes: '\\x01\\xAB\\x00',
  decimal: '1, 171, 0',
};

test.each(Object.keys(byteFormats) as ByteFormat[])('bytes as %s', (format) => {
  expect(writeBytes(frame, format)).toBe(WRITTEN[format]);
});
