import { describe, expect, it } from 'vitest';
import { checksum, checksums } from '../../../../src/modbus/index.ts';
import {
  algorithmRow,
  readSort,
  sortedRows,
  sortText,
  valueBytes,
} from '../../../../src/workbench/checksum/algorithm-rows.ts';
import { finder } from '../../../../src/workbench/reference/search.ts';
import { hex } from '../../modbus/frames.ts';

describe('the bytes of a value', () => {
  it('come highest first, as many as its bits need', () => {
    expect(valueBytes(0x1af3, 16)).toEqual(hex('1A F3'));
    expect(valueBytes(0xf3, 16)).toEqual(hex('00 F3'));
    expect(valueBytes(0x1234567, 28)).toEqual(hex('01 23 45 67'));
    expect(valueBytes(0xffffffff, 32)).toEqual(hex('FF FF FF FF'));
    expect(valueBytes(5, 3)).toEqual(hex('05'));
  });
});

describe('the lines of the table', () => {
  const bytes = hex('210303E70004');
  const rows = checksums.map((one) => algorithmRow(one, one.name, checksum(one, bytes)));
  const found = (search: string) => rows.filter(finder(search)).map(({ name }) => name);

  it.each([
    // What a calculator on the web shows for these bytes; three of them it prints with their bytes swapped.
    ['CRC-16/ARC', 0x01f3],
    ['CRC-16/MODBUS', 0x1af3],
    ['Sick', 0xcd9a],
    ['CRC-16/XMODEM', 0x6083],
    ['CRC-16/IBM-3740', 0x6e93],
    ['CRC-16/SPI-FUJITSU', 0x51bd],
    ['CRC-16/KERMIT', 0x7aca],
    ['CRC-16/DNP', 0x78c2],
    ['CRC-32/ISO-HDLC', 0x83e7a032],
    ['SUM-8', 0x12],
  ])('have the value of %s', (name, value) => {
    expect(rows.find((row) => row.name === name)?.value).toBe(value);
  });

  it('are found by name, value in either order, and polynomial', () => {
    expect(found('0x1AF3')).toEqual(['CRC-16/MODBUS']);
    expect(found('0xC278')).toEqual(['CRC-16/DNP']);
    expect(found('ca7a')).toEqual(['CRC-16/KERMIT']);
    expect(found('a001 ffff')).toEqual(expect.arrayContaining(['CRC-16/MODBUS', 'CRC-16/USB']));
    expect(found('ccitt')).toContain('CRC-16/KERMIT');
    // As a calculator on the web names it.
    expect(found('CRC-CCITT (0x1D0F)')).toEqual(['CRC-16/SPI-FUJITSU']);
    expect(found('zmodem')).toEqual(['CRC-16/XMODEM']);
  });

  it('stand in the order that is asked for, and the address says it', () => {
    const by = (text: string) => sortedRows(rows, readSort(text)).map(({ value }) => value!);
    expect(by('value')).toEqual(by('value').toSorted((a, b) => a - b));
    expect(by('-value')).toEqual(by('value').toReversed());
    expect(sortedRows(rows, readSort('nothing'))).toBe(rows);
    expect(sortText(readSort('-check'))).toBe('-check');
  });
});
