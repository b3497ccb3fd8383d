import fc from 'fast-check';
import { expect, test } from 'vitest';
import { readSheets } from '../../../../src/devices/maps/read-sheets.ts';

const tablesOf = (text: string) => readSheets(text).sheets.map(({ rows }) => rows.map(({ cells }) => cells));

test('reads the tables of a page with the headings above them', () => {
  const page = `<!doctype html><title>x<table></title><style>td > a {}</style><script>"<table><tr><td>no"</script>
    <h2>Holding &amp; input</h2><!-- <table><tr><td>no</td></tr></table> -->
    <TABLE class="a>b"><thead><tr><th>Name<th>Address</thead>
    <tr><td>Flow<br>temperature<td>  40001
    </td></tr><tr><td>Limit &lt;5&nbsp;&deg;C, &#937; &#x3a9;</td><td><p>1</p><p>2</p></td></tr></table>
    <table><caption>Coils</caption><tr><td>Pump</td></tr></table>`;
  expect(readSheets(page)).toMatchObject({
    format: 'html',
    sheets: [
      {
        name: 'Holding & input',
        kind: 'html',
        rows: [
          { line: 1, cells: ['Name', 'Address'] },
          { line: 2, cells: ['Flow\ntemperature', '40001'] },
          { line: 3, cells: ['Limit <5 °C, Ω Ω', '1\n2'] },
        ],
      },
      { name: 'Coils', kind: 'html', rows: [{ line: 1, cells: ['Pump'] }] },
    ],
  });
});

test('cells over several columns and rows cover them', () => {
  const table = `<table><tr><th rowspan=2>Name</th><th colspan="2">Address</th><th>Unit</th><th>Note</th></tr><tr><th>dec</th><th>hex</th><th></th><th></th></tr>
    <tr><td colspan=5>Group</td></tr><tr><td rowspan=3>A</td><td>1</td><td>0x1</td><td rowspan=2>V</td><td></td></tr><tr><td>2</td><td>0x2</td><td>x</td></tr></table>`;
  expect(readSheets(table).sheets[0]?.rows).toEqual([
    { line: 1, cells: ['Name', 'Address', 'Address', 'Unit', 'Note'] },
    { line: 2, cells: ['Name', 'dec', 'hex', '', ''], merged: [0] },
    { line: 3, cells: ['Group', '', '', '', ''] },
    { line: 4, cells: ['A', '1', '0x1', 'V', ''] },
    { line: 5, cells: ['A', '2', '0x2', 'V', 'x'], merged: [0, 3] },
  ]);
});

test('reads a range that a spreadsheet put on the clipboard', () => {
  const clipboard = `<html xmlns:x="urn:schemas-microsoft-com:office:excel"><body><table border=0 style='width:96pt'><!--StartFragment-->
    <col width=64 style='mso-width-source:userset'><tr height=20><td class=xl65 style='mso-number-format:"\\@"'>0064</td><td align=right>1</td></tr><!--EndFragment--></table></body></html>`;
  expect(tablesOf(clipboard)).toEqual([[['0064', '1']]]);
  expect(tablesOf('Name\tAddress\r\n"Two\nlines"\t40001\r\n')).toEqual([
    [
      ['Name', 'Address'],
      ['Two\nlines', '40001'],
    ],
  ]);
});

test('reads a table in a cell of a table', () => {
  expect(tablesOf('<table><tr><td>a<table><tr><td>b</td></tr></table></td><td>c</td></tr></table>')).toEqual([
    [['b']],
    [['a', 'c']],
  ]);
});

test('reads tables of Markdown, each with its heading, and their line breaks, signs and escaped bars', () => {
  const text =
    '# Map\n\nSome words: none.\n\n## Holding\n\n| Name | Address |\n|:-----|--------:|\n| `Flow \\| a` | **40001** |\n| Two<br/>lines | 2, see [one](#one) |\n\nInput registers:\nName | Address\n--- | ---\nX | 1\nY |\n';
  expect(readSheets(text)).toEqual({
    encoding: '',
    format: 'markdown',
    problems: [],
    sheets: [
      {
        name: 'Holding',
        kind: 'markdown',
        rows: [
          { line: 7, cells: ['Name', 'Address'] },
          { line: 9, cells: ['Flow | a', '40001'] },
          { line: 10, cells: ['Two\nlines', '2, see one'] },
        ],
      },
      {
        name: 'Input registers',
        kind: 'markdown',
        rows: [
          { line: 13, cells: ['Name', 'Address'] },
          { line: 15, cells: ['X', '1'] },
          { line: 16, cells: ['Y'] },
        ],
      },
    ],
  });
});

test('reads a table that is drawn with bars', () => {
  expect(
    tablesOf(
      '+------+---------+\n| Name | Address |\n+======+=========+\n| A    | 1       |\n+------+---------+\n| B    |         |\n+------+---------+\n',
    ),
  ).toEqual([
    [
      ['Name', 'Address'],
      ['A', '1'],
      ['B', ''],
    ],
  ]);
});

const cell = fc.string({ minLength: 1, maxLength: 6, unit: fc.constantFrom(...'aB0é&<">;,') });
const table = fc.array(fc.tuple(cell, cell, cell), { minLength: 1, maxLength: 8 });
const escaped = (text: string) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;');

test('every cell of a table of HTML comes out again', () => {
  fc.assert(
    fc.property(table, (rows) => {
      const text = `<table>${rows.map((cells) => `<tr>${cells.map((each) => `<td>${escaped(each)}</td>`).join('')}</tr>`).join('\n')}</table>`;
      expect(tablesOf(text)).toEqual([rows]);
    }),
  );
});

test('every cell of a table of Markdown comes out again', () => {
  fc.assert(
    fc.property(table, (rows) => {
      const lines = rows.map((cells) => `| ${cells.map((each) => each.replaceAll('|', '\\|')).join(' | ')} |`);
      expect(tablesOf([lines[0], '|---|---|---|', ...lines.slice(1)].join('\n'))).toEqual([rows]);
    }),
  );
});

test('any text with tags is read', () => {
  const piece = fc.constantFrom(
    '<table>',
    '<tr>',
    '<td rowspan=9 colspan=3>',
    '</td>',
    '</table>',
    '<h1>',
    '</h1>',
    '<caption>',
    'x',
    '<!--',
    '-->',
    '<',
    '>',
    '"',
    '<a b="',
    '&#99999999;',
    '|',
    '|---|---|\n',
    '\n',
  );
  fc.assert(
    fc.property(fc.array(piece, { maxLength: 30 }), (pieces) => {
      expect(Array.isArray(readSheets(`<table>${pieces.join('')}`).sheets)).toBe(true);
      expect(Array.isArray(readSheets(pieces.join('')).sheets)).toBe(true);
    }),
  );
});
