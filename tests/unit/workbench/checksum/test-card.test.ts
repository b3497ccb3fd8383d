import { describe, expect, it } from 'vitest';
import { languages } from '../../../../src/words/index.ts';
import { cardC, cardCsv, cardRows, exampleRows } from '../../../../src/workbench/checksum/test-card.ts';
import { exampleSources } from '../../../../src/workbench/examples/examples.ts';
import { hex } from '../../modbus/frames.ts';

const words = await languages.en.checksumCard();
const known = cardRows(words.sources);
const examples = exampleRows(exampleSources, (await languages.en.examples()).sources);

/** What is said of a printed value. */
const verdicts = (rows: typeof known) => rows.map(({ printed, verdict }) => `${printed} ${verdict}`);

describe('the test card', () => {
  it('says of each value whether it comes out', () => {
    expect(verdicts(known.filter(({ source }) => source === words.sources.calculator))).toEqual([
      '18 right',
      '0x01F3 right',
      '0x1AF3 right',
      '0x9ACD swapped',
      '0x6083 right',
      '0x6E93 right',
      '0x51BD right',
      '0xCA7A swapped',
      '0xC278 swapped',
      '0x83E7A032 right',
      '210 right',
    ]);
    expect(verdicts(known.filter(({ source }) => source === words.sources.specification))).toEqual([
      '41 12 right',
      '0x4112 swapped',
    ]);
    expect(known.filter(({ verdict }) => verdict === 'wrong')).toEqual([]);
  });

  it('marks what the guide for a drive prints', () => {
    const rows = examples.filter(({ source }) => source === 'A guide for a WEG drive');
    expect(verdicts(rows)).toEqual(['E6 A1 wrong', 'F5 27 wrong', '26 35 wrong', 'D5 E7 wrong']);
    // 06 06 02 AB 10 00 F5 E5.
    expect(rows[0]!.value).toBe(0xe5f5);
    expect(examples.some(({ verdict }) => verdict === 'right')).toBe(true);
  });

  it('has what is printed with a CRC, and nothing that is not', () => {
    // 01 10 21 00 00 02 4B F4 of the I-8xx7 manual, and 06 03 02 10 00 of the guide, which has no CRC.
    const of = (bytes: string) => examples.find((row) => String(row.bytes) === String(hex(bytes)));
    expect(of('01 10 21 00 00 02')).toMatchObject({ printed: '4B F4', value: 0xf44b, verdict: 'right' });
    expect(of('06 03 02')).toBeUndefined();
    expect(of('06 03 02 10 00')).toBeUndefined();
  });

  it('is copied for a spreadsheet and for a program', () => {
    const csv = cardCsv(known, ['a', 'b', 'c', 'd', 'e', 'f']).split('\n');
    expect(csv).toHaveLength(1 + known.length);
    expect(csv[1]).toBe('02 07,CRC-16/MODBUS,41 12,0x1241,right,Serial Line §6.2.2');
    const c = cardC(known);
    expect(c).toContain('  { 2, { 0x02, 0x07 }, 0x1241 },');
    expect(c).toContain('  { 5, { 0x01, 0x04, 0x02, 0xFF, 0xFF }, 0x80B8 },');
    expect(c.match(/0x02, 0x07 }/g)).toHaveLength(1);
  });
});
