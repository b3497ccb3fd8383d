import { expect, test } from 'vitest';
import { decodeFrame, fromHex } from '../../../../src/modbus/index.ts';
import { type FrameNames, frameName } from '../../../../src/workbench/index.ts';

const read = (hex: string, direction: 'request' | 'response' = 'request') =>
  decodeFrame(fromHex(hex)!, { transport: 'rtu', direction });

test.each([
  ['060602AB1000F5E5', 'request', 'write 683 4096'],
  ['060602AA00016825', 'request', 'write 682 1'],
  ['060602AA0000A9E5', 'request', 'write 682 0'],
  ['060302A900015425', 'request', 'read 681 1'],
  ['11050013FF007EAF', 'request', 'write 19 on'],
  ['060602AB1000F5E5', 'response', 'reply write 683 4096'],
  ['118302C134', 'response', 'exception 03 2'],
  ['0711', 'request', 'function 11'],
] as const)('%s as a %s is called %s', (hex, direction, name) => {
  expect(frameName(read(hex, direction)).join(' ')).toBe(name);
});

test('with the names of a device', () => {
  const short: Readonly<Record<string, string>> = { address: 'P0683', value: '30.0 Hz' };
  const names = { short: (name: string) => short[name] ?? '' } as FrameNames;
  expect(frameName(read('060602AB1000F5E5'), names)).toEqual(['write', 'p0683', '30', 'hz']);
});
