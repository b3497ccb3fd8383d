import { readdir } from 'node:fs/promises';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { codeRange, describeFunction, functionCodes, rawFunction, vendorOf } from '../../../../src/modbus/index.ts';

test('the public function codes, their names and sections (AP 5.1, AP 6)', () => {
  expect(functionCodes.map(({ code, name, section }) => [code, name, section])).toEqual([
    [0x01, 'Read Coils', 'AP 6.1'],
    [0x02, 'Read Discrete Inputs', 'AP 6.2'],
    [0x03, 'Read Holding Registers', 'AP 6.3'],
    [0x04, 'Read Input Registers', 'AP 6.4'],
    [0x05, 'Write Single Coil', 'AP 6.5'],
    [0x06, 'Write Single Register', 'AP 6.6'],
    [0x07, 'Read Exception Status', 'AP 6.7'],
    [0x08, 'Diagnostics', 'AP 6.8'],
    [0x0b, 'Get Comm Event Counter', 'AP 6.9'],
    [0x0c, 'Get Comm Event Log', 'AP 6.10'],
    [0x0f, 'Write Multiple Coils', 'AP 6.11'],
    [0x10, 'Write Multiple Registers', 'AP 6.12'],
    [0x11, 'Report Server ID', 'AP 6.13'],
    [0x14, 'Read File Record', 'AP 6.14'],
    [0x15, 'Write File Record', 'AP 6.15'],
    [0x16, 'Mask Write Register', 'AP 6.16'],
    [0x17, 'Read/Write Multiple Registers', 'AP 6.17'],
    [0x18, 'Read FIFO Queue', 'AP 6.18'],
    [0x2b, 'Encapsulated Interface Transport', 'AP 6.19'],
  ]);
});

test('every description has a file that is named by its code, and every such file is in the catalogue', async () => {
  const names = await readdir(join(import.meta.dirname, '../../../../src/modbus/functions'));
  // 2b-0e-… is a part of 2b-….
  const described = names.flatMap((name) => /^([0-9a-f]{2})-(?![0-9a-f]{2}-)/.exec(name)?.[1] ?? []);
  expect(described.sort()).toEqual(functionCodes.map(({ code }) => code.toString(16).padStart(2, '0')));
});

const codesWhere = (flag: 'serialOnly' | 'broadcast') =>
  functionCodes.flatMap((description) => (flag in description ? [description.code] : []));

test('which are for the serial line only (AP 6), and which may be broadcast (PI)', () => {
  expect(codesWhere('serialOnly')).toEqual([0x07, 0x08, 0x0b, 0x0c, 0x11]);
  expect(codesWhere('broadcast')).toEqual([0x05, 0x06, 0x0f, 0x10]);
});

/** AP 5 and AP Annex A, transcribed. */
const expectedRange = (code: number) => {
  if (code === 0) return 'zero';
  if (code >= 128) return 'exception';
  if ([1, 2, 3, 4, 5, 6, 7, 8, 11, 12, 15, 16, 17, 20, 21, 22, 23, 24, 43].includes(code)) return 'public';
  if ((code >= 65 && code <= 72) || (code >= 100 && code <= 110)) return 'user-defined';
  return [9, 10, 13, 14, 41, 42, 90, 91, 125, 126, 127].includes(code) ? 'reserved' : 'unassigned';
};

test('every code has its range', () => {
  for (let code = 0; code < 256; code++) expect(codeRange(code), String(code)).toBe(expectedRange(code));
});

test('codes without a layout of their own are raw data, and a reply with the exception bit is an exception', () => {
  expect(describeFunction(0x41, 'request')).toBe(rawFunction);
  expect(describeFunction(0x81, 'request')).toBe(rawFunction);
  expect(describeFunction(0x81, 'response').name).toBe('Exception');
  expect(describeFunction(0xff, 'response').name).toBe('Exception');
  expect(describeFunction(0x03, 'response').code).toBe(0x03);
});

test('some codes are known to be used by a company', () => {
  expect(vendorOf(90)).toContain('UMAS');
  expect(vendorOf(70)).toContain('Fast Modbus');
  expect(vendorOf(13)).toContain('Program Controller');
  expect(vendorOf(65)).toBeUndefined();
});
