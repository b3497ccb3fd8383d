import { expect, it } from 'vitest';
import { languages } from '../../../src/words/index.ts';

/** Every text that a thing holds, however deep, with the way to it. */
function* textsIn(thing: unknown, way: string): Generator<readonly [string, string]> {
  if (typeof thing === 'string') yield [way, thing];
  else if (typeof thing === 'object' && thing !== null)
    for (const [name, inner] of Object.entries(thing)) yield* textsIn(inner, `${way}.${name}`);
}

it('an ellipsis at the end of a text follows its word at once', async () => {
  const subjects = await Promise.all(
    Object.entries(languages.en).map(async ([name, load]) => [name, await (load as () => Promise<unknown>)()] as const),
  );
  const texts = subjects.flatMap(([name, words]) => [...textsIn(words, name)]);
  expect(texts.length).toBeGreaterThan(500);
  expect(texts.filter(([, text]) => /[\p{L}”] …$/u.test(text))).toEqual([]);
});
