import { describe, expect, it } from 'vitest';
import { cardC, cardCsv, cardRows, exampleRows, misprintRows } from '../../../src/ui/checksum-card/card.ts';
import { exampleSources } from '../../../src/ui/examples/examples.ts';
import { loadChecksumCardWords, loadReferenceWords, loadShelfWords } from '../../../src/words/index.ts';
import { hex } from '../modbus/frames.ts';

const words = await loadChecksumCardWords();
const known = cardRows(words.sources);
const examples = exampleRows(exampleSources, (await loadShelfWords()).examples.sources);
const misprints = misprintRows((await loadReferenceWords()).misprints);

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

  it('has the frames in print whose checksum alone is wrong', () => {
    const of = (bytes: string) => misprints.find((row) => String(row.bytes) === String(hex(bytes)));
    expect(of('01 03 00 3E 00 01')).toMatchObject({ printed: 'DD FA', value: 0xc6e5, verdict: 'wrong' });
    expect(of('01 82 03')).toMatchObject({ printed: 'A1 00', value: 0xa100, verdict: 'swapped' });
    expect(of('01 03 00 00 00 0A')).toMatchObject({ algorithm: 'LRC', printed: '0xFB', value: 0xf2, verdict: 'wrong' });
    expect(misprints.length).toBeGreaterThan(25);
  });

  it('is copied for a spreadsheet and for a program', () => {
    const csv = cardCsv([...known, ...misprints], ['a', 'b', 'c', 'd', 'e', 'f']).split('\n');
    expect(csv).toHaveLength(1 + known.length + misprints.length);
    expect(csv[1]).toBe('02 07,CRC-16/MODBUS,41 12,0x1241,right,Serial Line §6.2.2');
    const c = cardC([...known, ...misprints]);
    expect(c).toContain('  { 2, { 0x02, 0x07 }, 0x1241 },');
    expect(c).toContain('  { 3, { 0x01, 0x82, 0x03 }, 0xA100 },');
    expect(c.match(/0x02, 0x07 }/g)).toHaveLength(1);
  });
});
