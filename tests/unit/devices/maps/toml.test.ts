import fc from 'fast-check';
import { expect, test } from 'vitest';
import type { SheetProblem } from '../../../../src/devices/maps/sheet.ts';
import { readToml } from '../../../../src/devices/maps/toml.ts';

const read = (text: string) => {
  const problems: SheetProblem[] = [];
  return { value: JSON.parse(JSON.stringify(readToml(text, problems))), problems };
};

test('reads tables, lists of tables, and dotted and quoted keys', () => {
  expect(read('a = 1\n[b.c]\nd."e f" = true # x\n[[g]]\nh = 1\n[[g]]\n[g.i]\nj = 2\n')).toEqual({
    value: { a: 1, b: { c: { d: { 'e f': true } } }, g: [{ h: 1 }, { i: { j: 2 } }] },
    problems: [],
  });
});

test('reads strings of all four kinds', () => {
  expect(
    read(
      'a = "x\\ty \\u00e9 \\"z\\" \\\\"\nb = \'C:\\n\'\nc = """\none \\\n  two"""\nd = \'\'\'\n"three"\n\'\'\'\ne = ""',
    ).value,
  ).toEqual({
    a: 'x\ty é "z" \\',
    b: 'C:\\n',
    c: 'one two',
    d: '"three"\n',
    e: '',
  });
});

test('keeps numbers whose digits say more as texts, and reads lists and inline tables over several lines', () => {
  expect(
    read('a = [1, 0x10, 1_000, 1.0, # c\n  -2.5,\n]\nb = { c = [ {d = 1}, ],\n e.f = "g" }\nh = 2024-01-01\n').value,
  ).toEqual({
    a: [1, '0x10', '1_000', '1.0', -2.5],
    b: { c: [{ d: 1 }], e: { f: 'g' } },
    h: '2024-01-01',
  });
});

test.each([
  ['a = \n', 1],
  ['a = 1\nb = "x\n', 2],
  ['a = [1 2]', 1],
  ['a = 1 b = 2', 1],
  ['a = 1\n[a.b]\n', 2],
  ['[a\n', 1],
  [`a = ${'['.repeat(200)}`, 1],
])('%j has an error in line %i', (text, line) => {
  expect(read(text).problems).toMatchObject([{ code: 'unreadable', format: 'toml', line }]);
});

test('any text is read up to its first error', () => {
  const piece = fc.constantFrom(
    '[',
    ']',
    '[[',
    ']]',
    'a',
    '.',
    '=',
    '"',
    "'",
    '\n',
    ' ',
    '1',
    '{',
    '}',
    ',',
    '#',
    '\\',
    '__proto__',
  );
  fc.assert(
    fc.property(fc.array(piece, { maxLength: 30 }), (pieces) => {
      expect(read(pieces.join('')).problems.length).toBeLessThan(2);
    }),
  );
});
