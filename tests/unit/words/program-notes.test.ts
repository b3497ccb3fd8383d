import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { expect, test } from 'vitest';
import { program } from '../../../src/words/en/program.ts';

// Notes are codes of the targets, too: each that one of them makes has a sentence.
test('every note of a program is said in words', () => {
  const folder = join(import.meta.dirname, '../../../src/codegen');
  const codes = new Set<string>();
  for (const file of readdirSync(folder, { recursive: true, encoding: 'utf8' })) {
    if (!file.endsWith('.ts')) continue;
    for (const [, code = ''] of readFileSync(join(folder, file), 'utf8').matchAll(/\bcode: '([a-z-]+)'/g))
      codes.add(code);
  }
  expect(codes.size).toBeGreaterThan(2);
  for (const code of codes) expect(program.note(code, {}, 'C99'), code).not.toMatch(/^Note: /);
});

test('a note says what it is about', () => {
  expect(program.note('not-offered', { what: 'tcp' }, 'mbpoll')).toBe(
    'mbpoll is not written for TCP: the bytes are written alone.',
  );
  expect(program.note('not-offered', { what: 'baud', baud: 12_345, instead: 9600 }, 'C99')).toBe(
    '12345 baud cannot be set by this program: it sets 9600.',
  );
  expect(program.note('name-changed', { from: 'int', to: 'int_2' }, 'C99')).toBe(
    '“int” cannot be a name here: it is called int_2.',
  );
  expect(program.note('constant', { request: 'read', why: 'forced' }, 'C99')).toBe(
    'The bytes of “read” are constants, because some of its values are forced.',
  );
});
