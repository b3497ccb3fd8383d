import { expect, it } from 'vitest';
import { isTextNote, readText } from '../../../../src/workbench/index.ts';

it('says what could not be read before what is only noted, so that notes hide nothing', () => {
  const comments = Array.from({ length: 300 }, (_, i) => `a comment, ${10 + (i % 80)} of them`).join('\n');
  const { problems } = readText(`${comments}\nTX: 01 03 00 00 00 0A C5 CDF\n`, undefined);
  expect(problems[0]).toMatchObject({ code: 'odd-digits' });
  expect(problems.findLastIndex((one) => !isTextNote(one))).toBeLessThan(problems.findIndex(isTextNote));
});

it('tells how much of a long text is read, in whole percent, each once, up to the end', () => {
  const told: number[] = [];
  const log = 'Tx 11 03 00 6B 00 01 F7 16\nRx 11 03 02 02 2B F9 F8\n'.repeat(500);
  const { items } = readText(log, undefined, (percent) => told.push(percent));
  expect(items).toHaveLength(1000);
  expect(told).toEqual([...new Set(told)].sort((one, other) => one - other));
  expect(told.length).toBeGreaterThan(80);
  expect([told[0], told.at(-1)]).toEqual([1, 99]);
});
