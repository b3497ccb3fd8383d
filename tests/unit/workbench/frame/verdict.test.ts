import { expect, test } from 'vitest';
import { decodeFrame, fromHex } from '../../../../src/modbus/index.ts';
import { verdictOf } from '../../../../src/workbench/index.ts';

test.each([
  ['060602AB1000F5E5', 'valid'],
  // The guide's own CRC.
  ['060602AB1000E6A1', 'wrong-checksum'],
  // 126 registers, with a right and with a wrong CRC.
  ['01030000007EC5EA', 'invalid'],
  ['01030000007E0000', 'invalid'],
  ['060602AB', 'incomplete'],
])('%s is %s', (hex, verdict) => {
  expect(verdictOf(decodeFrame(fromHex(hex)!, { transport: 'rtu', direction: 'request' }))).toBe(verdict);
});

test('a frame whose address may be two things is not valid before somebody has said which', () => {
  const verdict = (hex: string) =>
    verdictOf(decodeFrame(fromHex(hex)!, { transport: 'rtu', direction: 'request' }), true);
  expect(verdict('1103006B00037687')).toBe('doubtful');
  expect(verdict('1103006B00030000')).toBe('wrong-checksum');
});
