import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { reference } from '../../../../src/words/en/reference.ts';
import { finder, type Searchable } from '../../../../src/workbench/reference/search.ts';

const row = (text: string, ...codes: Searchable['codes']): Searchable => ({ text, codes });
const writeMultiple = row('1016 Write Multiple Registers holding registers quantity 1–123 §6.12', 0x10);
const mask = row('1622 Mask Write Register 0x0016', 0x16);
const device = row('2B43 Read Device Identification 43/14', 0x2b);
const range = row('80–FF exception codes', [0x80, 0xff]);

describe('a search', () => {
  const finds = (search: string, ...rows: Searchable[]) => rows.map(finder(search));

  it('of 2 MB is no error, and is searched for by its beginning', () => {
    expect(finds('x'.repeat(2_000_000), writeMultiple)).toEqual([false]);
    expect(finds('('.repeat(2_000_000), writeMultiple)).toEqual([false]);
    expect(finds(`mask write ${' '.repeat(2_000_000)}x`, mask)).toEqual([true]);
  });

  it('finds a code in decimal and hexadecimal, and as FC16', () => {
    for (const search of ['16', '0x10', '10h', 'FC16', 'fc16', '16#10'])
      expect(finds(search, writeMultiple), search).toEqual([true]);
    for (const search of ['43', '2b', '0x2B', '2Bh']) expect(finds(search, device), search).toEqual([true]);
  });

  it('finds a number only where it stands alone', () => {
    expect(finds('12', writeMultiple)).toEqual([false]);
    expect(finds('123', writeMultiple)).toEqual([true]);
    expect(finds('14', device)).toEqual([true]);
    expect(finds('6.12', writeMultiple)).toEqual([true]);
    expect(finds('6.1', writeMultiple)).toEqual([false]);
  });

  it('finds a code within a range', () => {
    expect(finds('129', range)).toEqual([true]);
    expect(finds('0xFF', range)).toEqual([true]);
    expect(finds('127', range)).toEqual([false]);
    expect(finds('256', range)).toEqual([false]);
  });

  it('finds words and parts of words in any case, and all of them', () => {
    expect(finds('WRITE holding', writeMultiple, mask)).toEqual([true, false]);
    expect(finds('write, regist', writeMultiple, mask)).toEqual([true, true]);
    expect(finds(' ', writeMultiple, mask)).toEqual([true, true]);
  });

  it('takes signs as they are', () => {
    expect(finds('1–123', writeMultiple)).toEqual([true]);
    for (const sign of ['.*', '(', '[', '\\', '$^']) expect(finds(sign, writeMultiple), sign).toEqual([false]);
    fc.assert(fc.property(fc.string(), (search) => typeof finder(search)(mask) === 'boolean'));
  });
});

describe('when it does not work', () => {
  it('is found by the words people have for it', () => {
    const { troubles: signs, foundBy } = reference;
    const found = (search: string) =>
      Object.entries(signs).flatMap(([sign, { title, text }]) =>
        finder(search)({ text: `${title} ${text} ${foundBy.troubles}`, codes: [] }) ? [sign] : [],
      );
    expect(found('no answer')).toContain('silence');
    expect(found('timeout').length).toBeGreaterThan(1);
    expect(found('termination')).toContain('sometimes');
    expect(found('echo')).toContain('echo');
    expect(found('coil')).toEqual([]);
  });
});
