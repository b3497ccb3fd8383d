import { describe, expect, it } from 'vitest';
import { functionCodes } from '../../../../src/modbus/index.ts';
import { languages } from '../../../../src/words/index.ts';
import { findFunctions, functionsByUse, functionWith, valuesByUse } from '../../../../src/workbench/index.ts';

const { page: words } = await languages.en.page();
const names = (query: string) => findFunctions(query).map(words.functionIn);

describe('functions are offered', () => {
  it('with their codes in both bases, by their use and then by number', () => {
    expect(functionsByUse.map(words.functionIn)).toEqual([
      '03 Read Holding Registers',
      '06 Write Single Register',
      '16 (0x10) Write Multiple Registers',
      '04 Read Input Registers',
      '01 Read Coils',
      '05 Write Single Coil',
      '15 (0x0F) Write Multiple Coils',
      '02 Read Discrete Inputs',
      '23 (0x17) Read/Write Multiple Registers',
      '22 (0x16) Mask Write Register',
      '43/14 (0x2B/0x0E) Read Device Identification',
      '08 Diagnostics (serial line only)',
      '17 (0x11) Report Server ID (serial line only)',
      '07 Read Exception Status (serial line only)',
      '11 (0x0B) Get Comm Event Counter (serial line only)',
      '12 (0x0C) Get Comm Event Log (serial line only)',
      '20 (0x14) Read File Record',
      '21 (0x15) Write File Record',
      '24 (0x18) Read FIFO Queue',
      '43/13 (0x2B/0x0D) CANopen General Reference',
    ]);
  });

  it('each public one, and each is the one that its texts choose', () => {
    expect(new Set(functionsByUse.map(({ code }) => code))).toEqual(new Set(functionCodes.map(({ code }) => code)));
    for (const each of functionsByUse)
      expect(functionWith(Number(each.texts['functionCode']), Number(each.texts['meiType']))).toBe(each);
    expect(functionWith(43, 99)?.name).toBe('Encapsulated Interface Transport');
    expect(functionWith(65, undefined)).toBeUndefined();
  });

  it('with MEI type 0E before 0D, also where it is chosen by itself', () => {
    expect(valuesByUse('meiType', [13, 14])).toEqual([14, 13]);
    expect(valuesByUse('readDeviceIdCode', [1, 2, 3, 4])).toEqual([1, 2, 3, 4]);
  });
});

describe('functions are found', () => {
  it('by the beginnings of the words of their names, whatever the case', () => {
    expect(names('HOLDING')).toEqual(['03 Read Holding Registers']);
    expect(names('write').slice(0, 2)).toEqual(['06 Write Single Register', '16 (0x10) Write Multiple Registers']);
    expect(names('write mult reg')[0]).toBe('16 (0x10) Write Multiple Registers');
    expect(names('nothing of the kind')).toEqual([]);
    expect(names('  ')).toEqual([]);
  });

  it('by a code in decimal before the same digits in hexadecimal', () => {
    expect(names('16')).toEqual(['16 (0x10) Write Multiple Registers', '22 (0x16) Mask Write Register']);
    expect(names('0x10')).toEqual(['16 (0x10) Write Multiple Registers']);
    expect(names('10h')).toEqual(['16 (0x10) Write Multiple Registers']);
    expect(names('3')[0]).toBe('03 Read Holding Registers');
  });

  it('of 43 the one that reads the identification first', () => {
    for (const query of ['43', '2b', '0x2B', '43/14', '2B/0E'])
      expect(findFunctions(query)[0]?.texts).toEqual({ functionCode: '43', meiType: '14' });
    expect(names('43/13')).toEqual(['43/13 (0x2B/0x0D) CANopen General Reference']);
  });

  it('with the sub-functions under them', () => {
    expect(findFunctions('restart communications')[0]?.texts).toEqual({ functionCode: '8', subFunction: '1' });
    expect(names('08/10')[0]).toMatch(/^08\/10 \(0x08\/0x0A\) Clear Counters/);
  });

  it('also where a code has no name, with whom it is for', () => {
    // 65 is user-defined (AP 4.1), hexadecimal 65 is 101, too.
    expect(findFunctions('65')).toMatchObject([
      { code: 65, range: 'user-defined', texts: { functionCode: '65' } },
      { code: 101, range: 'user-defined' },
    ]);
    expect(names('65')[0]).toBe('65 (0x41), user-defined');
    expect(names('0x80')).toEqual(['128 (0x80), the range of exceptions']);
    expect(findFunctions('256')).toEqual([]);
  });

  it('at most eight at a time', () => {
    expect(findFunctions('r')).toHaveLength(8);
  });
});
