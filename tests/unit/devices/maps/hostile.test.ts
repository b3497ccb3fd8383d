import { strToU8, zipSync } from 'fflate';
import { expect, test } from 'vitest';
import { readSheets } from '../../../../src/devices/maps/read-sheets.ts';
import { usualLimits } from '../../../../src/devices/maps/sheet.ts';

const long = 200_000;

/** Texts on which a reader that goes back over what it has read would take hours. */
test.each([
  ['blanks', `| a | b |\n|---|---|\n${' '.repeat(long)}x`],
  ['hyphens', `| a | b |\n|---|---|\n+${'-'.repeat(long)}x`],
  ['a heading of blanks', `| a | b |\n|---|---|\n# ${' '.repeat(long)}x`],
  ['bars', '|'.repeat(long)],
  ['quotes', '"a""\n'.repeat(long / 5)],
  ['quotes and delimiters', '"a"b,'.repeat(long / 5)],
  ['quotes that never close', `a,b\n${'"x\n'.repeat(long / 3)}`],
  ['carriage returns', `a,b\r${'1,2\r'.repeat(long / 4)}\n`],
  ['digits', `[{"address":"${'1'.repeat(long)}x","map":{"${'1'.repeat(long)}x":1}}]`],
  ['quotes of JSON', `{${'\\"'.repeat(long / 2)}`],
  ['comments of JSON', `{${'/*'.repeat(long / 2)}`],
  ['commas of JSON', `{${', '.repeat(long / 2)}`],
  ['keys of digits', `{"${'1'.repeat(long)}x":{"a":1},"${'2'.repeat(long)}x":{"a":1}}`],
  ['tags', `<table>${'<'.repeat(long)}`],
  ['tags with quotes', `<table>${'<a b="'.repeat(long / 6)}`],
  ['comments', `<table>${'<!-'.repeat(long / 3)}`],
  ['scripts', `<table>${'<script></script '.repeat(long / 17)}`],
  ['entities', `<table><tr><td>${'&'.repeat(long)}`],
  ['wide cells', `<table>${'<tr>'.repeat(500)}${'<td colspan=1000 rowspan=1000>'.repeat(2000)}`],
  ['rows below wide cells', `<table><tr>${'<td colspan=1000 rowspan=1000>x'.repeat(100)}${'<tr>'.repeat(10_000)}`],
  ['tables in tables', '<table><tr><td>'.repeat(long / 15)],
  ['keys of TOML', `[a]\n${'x.'.repeat(long / 2)}`],
  ['backslashes of TOML', `[a]\nb = "${'\\'.repeat(long)}"`],
  ['braces of a template', `template: x\nrender: |\n  ${'{{'.repeat(long / 2)}\n  a: 1`],
  ['twice the same key', `registers:\n${'- a: 1\n'.repeat(100)}${'b: 1\n'.repeat(4000)}`],
])('%s take no longer than they are', (_what, text) => {
  expect(Array.isArray(readSheets(text, '', { ...usualLimits, cells: 400_000 }).sheets)).toBe(true);
});

test('a text that every cell of a workbook repeats does not stand for more than a file may hold', () => {
  const cells = Array.from({ length: 80 }, () => '<c t="s"><v>0</v></c>').join('');
  const file = zipSync({
    'xl/workbook.xml': strToU8('<workbook><sheets><sheet name="S" r:id="a"/></sheets></workbook>'),
    'xl/_rels/workbook.xml.rels': strToU8(
      '<Relationships><Relationship Id="a" Target="worksheets/s.xml"/></Relationships>',
    ),
    'xl/sharedStrings.xml': strToU8(`<sst><si><t>${'x'.repeat(30_000)}</t></si></sst>`),
    'xl/worksheets/s.xml': strToU8(`<worksheet><sheetData><row>${cells}</row></sheetData></worksheet>`),
  });
  expect(readSheets(file, '', { ...usualLimits, bytes: 2_000_000 }).problems).toEqual([
    { code: 'too-large', most: 2_000_000 },
  ]);
});
