import { describe, expect, it } from 'vitest';
import { readSerialFormat } from '../../../../src/modbus/index.ts';
import { languages } from '../../../../src/words/index.ts';
import { bitsGroups, speedTableText } from '../../../../src/workbench/timing/usual-speeds.ts';

const words = await languages.en.timing();
const groups = (format: string) => bitsGroups(readSerialFormat(format)!);

describe('the usual speeds', () => {
  it('stand in a group for each number of bits, the longest first', () => {
    const sizes = groups('8E1').map(({ bits }) => bits);
    expect(sizes).toEqual([11, 10]);
    expect(groups('8E1')[0]!.names).toEqual(expect.arrayContaining(['8E1', '8O1', '8N2']));
    expect(groups('8E1')[1]!.names).toEqual(expect.arrayContaining(['8N1', '7E1', '7O1', '7N2']));
  });

  it('have a group more for a format that is not common', () => {
    expect(groups('8E2').map(({ bits }) => bits)).toEqual([12, 11, 10]);
    expect(groups('8E2')[0]!.names).toEqual(['8E2']);
  });

  it('are copied in microseconds, fixed and counted silences apart', () => {
    const lines = speedTableText(groups('8E1'), 'tsv', words).split('\n');
    expect(lines[0]).toMatch(/^Speed\tCharacter, 11 bits, µs\tt1\.5, 11 bits, µs/);
    expect(lines).toContain(
      '19200\t572.917\t859.375\t2005.208\t859.375\t2005.208\t520.833\t781.250\t1822.917\t781.250\t1822.917',
    );
    expect(lines).toContain(
      '115200\t95.486\t750.000\t1750.000\t143.229\t334.201\t86.806\t750.000\t1750.000\t130.208\t303.819',
    );
  });
});
