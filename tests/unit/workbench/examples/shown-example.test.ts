import { expect, test } from 'vitest';
import { exampleSources } from '../../../../src/workbench/examples/examples.ts';
import { shownExample } from '../../../../src/workbench/examples/shown-example.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { readLink } from '../../../../src/workbench/frame/link.ts';

const run = exampleSources.flatMap(({ examples }) => examples).find(({ id }) => id === 'weg-run')!;
const shown = (link: string, among = new Set([run])) => {
  const { draft } = readLink(link)!;
  return shownExample(draft, evaluate(draft).frame, among)?.example.id;
};

test('an example is shown where its bytes are, however they were typed', () => {
  // 06 06 02 AA 00 01 68 25.
  expect(shown('#rtu/request?unitId=0x06&functionCode=6&address=0x02AA&value=1')).toBe('weg-run');
  expect(shown('#rtu/request?unitId=6&functionCode=6&address=682&value=2')).toBeUndefined();
  expect(shown('#rtu/reply?unitId=6&functionCode=6&address=682&value=1')).toBeUndefined();
  expect(shown('#ascii/request?unitId=6&functionCode=6&address=682&value=1')).toBeUndefined();
  expect(shown('#rtu/request?unitId=6&functionCode=6&address=682&value=1', new Set())).toBeUndefined();
  expect(shown('#rtu/request?unitId=6&functionCode=6&address=682&value=x')).toBeUndefined();
});
