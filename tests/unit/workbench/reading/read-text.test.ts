import { expect, it } from 'vitest';
import { isTextNote, readText } from '../../../../src/workbench/index.ts';

it('says what could not be read before what is only noted, so that notes hide nothing', () => {
  const comments = Array.from({ length: 300 }, (_, i) => `a comment, ${10 + (i % 80)} of them`).join('\n');
  const { problems } = readText(`${comments}\nTX: 01 03 00 00 00 0A C5 CDF\n`, undefined);
  expect(problems[0]).toMatchObject({ code: 'odd-digits' });
  expect(problems.findLastIndex((one) => !isTextNote(one))).toBeLessThan(problems.findIndex(isTextNote));
});
