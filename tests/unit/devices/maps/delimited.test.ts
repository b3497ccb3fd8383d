import fc from 'fast-check';
import { expect, test } from 'vitest';
import { readSheets } from '../../../../src/devices/maps/read-sheets.ts';

const cellsOf = (source: string | Uint8Array) => readSheets(source).sheets[0]?.rows.map(({ cells }) => cells);
const bytesOf = (text: string) => new TextEncoder().encode(text);
const latin = (text: string) => Uint8Array.from(text, (letter) => letter.charCodeAt(0));

test.each([
  ['commas', 'name,address\nA,0\n'],
  ['semicolons', 'name;address\nA;0\n'],
  ['tabs', 'name\taddress\nA\t0\n'],
  ['bars', 'name|address\nA|0\n'],
  ['columns of blanks', 'name     address\nA        0\n'],
  ['CR LF', 'name,address\r\nA,0\r\n'],
  ['CR alone', 'name,address\rA,0\r'],
  ['no line end at the end', 'name,address\nA,0'],
  ['quotes', '"name","address"\n"A","0"\n'],
  ['blanks beside quotes', 'name, "address"\n"A" ,0\n'],
])('reads a table with %s', (_what, text) => {
  expect(cellsOf(text)).toEqual([
    ['name', 'address'],
    ['A', '0'],
  ]);
});

test('takes the delimiter by which rows are alike, whatever the cells hold', () => {
  const text = 'Adresse;Bezeichnung;Einheit;Faktor\n0;Spannung, L1;V;0,1\n1;Strom;A;0,01\n2;a, b, c;;1\n';
  expect(cellsOf(text)?.[1]).toEqual(['0', 'Spannung, L1', 'V', '0,1']);
  expect(cellsOf('gps,/State,0=off;1=on;2=idle,2900\ngps,/Fix,,2901\ngps,/Speed,0=a;1=b,2902\n')?.[0]).toEqual([
    'gps',
    '/State',
    '0=off;1=on;2=idle',
    '2900',
  ]);
});

test('believes a first line that names the delimiter', () => {
  const [sheet] = readSheets('sep=;\nname,x;address\nA,y;0\n').sheets;
  expect(sheet?.rows).toEqual([
    { line: 2, cells: ['name,x', 'address'] },
    { line: 3, cells: ['A,y', '0'] },
  ]);
});

test('keeps line breaks and quotes inside quoted cells, and counts lines as the file does', () => {
  const [sheet] = readSheets('name,note\r\nA,"0: off\r\n1: ""on"", 2"\r\n\r\nB,x\r\n').sheets;
  expect(sheet?.rows).toEqual([
    { line: 1, cells: ['name', 'note'] },
    { line: 2, cells: ['A', '0: off\r\n1: "on", 2'] },
    { line: 5, cells: ['B', 'x'] },
  ]);
});

test.each([
  ['"A,1', ['A', '1']],
  ['A,"1', ['A', '1']],
  ['"the "best" one",1', ['the "best" one', '1']],
  ['"3" pipe,1', ['"3" pipe', '1']],
  ['3" pipe,1', ['3" pipe', '1']],
])('of %s the cells are %j', (line, cells) => {
  expect(cellsOf(`name,address\n${line}\nB,2\n`)?.[1]).toEqual(cells);
});

test('a quote without a partner costs its own row at most', () => {
  const rows = Array.from({ length: 30 }, (_, index) => `"3" pipe ${index},holding,${index}`);
  const [sheet] = readSheets(
    ['name,table,address', ...rows, '"A, B",holding,30', '"never closed,holding,31', 'C,holding,32'].join('\n'),
  ).sheets;
  expect(sheet?.rows).toHaveLength(34);
  expect(sheet?.rows.filter(({ open }) => open)).toHaveLength(31);
  expect(sheet?.rows[1]).toEqual({ line: 2, cells: ['"3" pipe 0', 'holding', '0'], open: true });
  expect(sheet?.rows[31]).toEqual({ line: 32, cells: ['A, B', 'holding', '30'] });
  expect(sheet?.rows[32]).toEqual({ line: 33, cells: ['never closed', 'holding', '31'], open: true });
  expect(sheet?.rows[33]).toEqual({ line: 34, cells: ['C', 'holding', '32'] });
});

test.each([
  ['utf-8', bytesOf('name;unit\nVorlauf;°C\n')],
  ['utf-8', bytesOf('\uFEFFname;unit\nVorlauf;°C\n')],
  ['windows-1252', latin('name;unit\nVorlauf;\u00b0C\n')],
  ['utf-16le', wide('\uFEFFname;unit\nVorlauf;°C\n', true)],
  ['utf-16le', wide('name;unit\nVorlauf;°C\n', true)],
  ['utf-16be', wide('\uFEFFname;unit\nVorlauf;°C\n', false)],
  ['utf-16be', wide('name;unit\nVorlauf;°C\n', false)],
])('reads %s', (encoding, bytes) => {
  const read = readSheets(bytes);
  expect(read.encoding).toBe(encoding);
  expect(read.sheets[0]?.rows.map(({ cells }) => cells)).toEqual([
    ['name', 'unit'],
    ['Vorlauf', '°C'],
  ]);
});

test('reads the signs that Windows-1252 has and Latin-1 lacks, and Chinese characters in two bytes', () => {
  expect(cellsOf(latin('name,unit\nPrice,\u0080\nRange,5\u009610\n'))).toEqual([
    ['name', 'unit'],
    ['Price', '€'],
    ['Range', '5–10'],
  ]);
  // 地址 and 名称 in GB 2312.
  const chinese = Uint8Array.from([0xb5, 0xd8, 0xd6, 0xb7, 0x2c, 0xc3, 0xfb, 0xb3, 0xc6, 0x0a, 0x31, 0x2c, 0x41, 0x0a]);
  expect(readSheets(chinese).encoding).toBe('gb18030');
  expect(cellsOf(chinese)).toEqual([
    ['地址', '名称'],
    ['1', 'A'],
  ]);
});

test('reads Polish as a spreadsheet of Windows saves it', () => {
  // Prąd, Napięcie zasilającego, żółty in Windows-1250; the volume of a Western table stays what it is.
  const polish = latin('nazwa;adres\nPr\u00b9d;0\nNapi\u00eacie zasilaj\u00b9cego;2\n\u00bf\u00f3\u00b3ty;3\n');
  expect(readSheets(polish).encoding).toBe('windows-1250');
  expect(cellsOf(polish)?.map(([name]) => name)).toEqual(['nazwa', 'Prąd', 'Napięcie zasilającego', 'żółty']);
  expect(readSheets(latin('name;unit\nVolume;m\u00b3/h\n\u00bfModo?;m\u00b3\n')).encoding).toBe('windows-1252');
});

test('a few damaged bytes in UTF-8 do not make it Latin-1', () => {
  const bytes = Uint8Array.from([...bytesOf('name,unit\nä,°C\nü,°F\n'), 0xff, 0x2c, 0x31]);
  expect(readSheets(bytes).encoding).toBe('utf-8');
  expect(readSheets(bytesOf('name,unit\n0 \uFFFD no error,V\n')).encoding).toBe('utf-8');
});

test('says why there is no table', () => {
  expect(readSheets('')).toEqual({ sheets: [], encoding: '', problems: [{ code: 'empty' }], format: '' });
  expect(readSheets(new Uint8Array(0)).problems).toEqual([{ code: 'empty' }]);
  expect(readSheets(Uint8Array.from({ length: 64 }, (_, index) => index)).problems).toEqual([{ code: 'not-a-table' }]);
});

const delimiters = fc.constantFrom(',', ';', '\t');
const cell = fc.string({ maxLength: 8, unit: fc.constantFrom(...'aB0é ,;\t"\n|-') }).map((text) => text.trim());

test('every cell of a table comes out again, whatever it holds', () => {
  fc.assert(
    fc.property(
      delimiters,
      fc.array(fc.tuple(fc.constantFrom('x', 'y z'), cell, cell, cell), { minLength: 2, maxLength: 12 }),
      (delimiter, rows) => {
        const text = rows
          .map((cells) => cells.map((each) => `"${each.replaceAll('"', '""')}"`).join(delimiter))
          .join('\r\n');
        expect(cellsOf(`sep=${delimiter}\r\n${text}`)).toEqual(rows);
      },
    ),
  );
});

test('any text gives rows whose cells hold all its letters and digits', () => {
  fc.assert(
    fc.property(fc.string({ unit: fc.constantFrom(...'ab1",;\n\r\t '), maxLength: 60 }), (text) => {
      const kept = (cellsOf(text) ?? [])
        .flat()
        .join('')
        .replace(/[^ab1]/g, '');
      expect(kept).toBe(text.replace(/[^ab1]/g, ''));
    }),
  );
});

test('any bytes are read or refused', () => {
  fc.assert(
    fc.property(fc.uint8Array({ maxLength: 300 }), (bytes) => {
      const { sheets, problems } = readSheets(bytes);
      expect(sheets.length + problems.length).toBeGreaterThan(0);
    }),
  );
});

function wide(text: string, little: boolean): Uint8Array {
  return Uint8Array.from(
    Array.from(text, (letter) => [letter.charCodeAt(0) & 0xff, letter.charCodeAt(0) >> 8]).flatMap(([low, high]) =>
      little ? [low, high] : [high, low],
    ) as number[],
  );
}
