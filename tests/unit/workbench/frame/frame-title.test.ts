import { expect, test } from 'vitest';
import { decodeFrame, type Transport } from '../../../../src/modbus/index.ts';
import { frameBeginning } from '../../../../src/workbench/frame/frame-title.ts';
import { hex } from '../../modbus/frames.ts';

const beginning = (transport: Transport, bytes: Uint8Array) =>
  frameBeginning(decodeFrame(bytes, { transport, direction: 'request' }), bytes);

test('a frame is named by its unit, its function and what follows', () => {
  expect(beginning('rtu', hex('06 06 02 AB 10 00 F5 E5'))).toBe('06 06 02AB …');
  expect(beginning('tcp', hex('00 01 00 00 00 06 09 03 00 04 00 01'))).toBe('09 03 0004 …');
  expect(beginning('pdu', hex('2B 0E 01 00'))).toMatch(/^2B 0E /);
  expect(beginning('ascii', new TextEncoder().encode(':1103006B00037E\r\n'))).toBe(':1103006B…');
});

test('a short frame is named whole', () => {
  expect(beginning('rtu', hex('11'))).toBe('11');
  expect(beginning('pdu', hex('07'))).toBe('07');
  expect(beginning('ascii', new TextEncoder().encode(':11\r\n'))).toBe(':11');
});
