import { expect, it } from 'vitest';
import { languages } from '../../../src/words/index.ts';

/** All sentences that are not made of something, with their places. */
function sentences(of: unknown, place: string): readonly (readonly [place: string, sentence: string])[] {
  if (typeof of === 'string') return [[place, of]];
  if (typeof of !== 'object' || of === null) return [];
  return Object.entries(of).flatMap(([name, each]) => sentences(each, `${place}.${name}`));
}

it('writes the dots of what goes on, or asks for more, without a blank before them', async () => {
  const all = await Promise.all(
    Object.entries(languages.en).map(async ([subject, load]) => sentences(await load(), subject)),
  );
  expect(all.flat().length).toBeGreaterThan(1000);
  expect(all.flat().filter(([, sentence]) => / …$/.test(sentence))).toEqual([]);
});
