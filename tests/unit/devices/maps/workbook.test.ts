import fc from 'fast-check';
import { gzipSync, strToU8, zipSync } from 'fflate';
import { expect, test } from 'vitest';
import { readSheets } from '../../../../src/devices/maps/read-sheets.ts';
import { usualLimits } from '../../../../src/devices/maps/sheet.ts';

const main =
  'xmlns="http://schemas.openxmlformats.org/spreadsheetml/2006/main" xmlns:r="http://schemas.openxmlformats.org/officeDocument/2006/relationships"';

interface Parts {
  readonly sheets: Readonly<Record<string, string>>;
  readonly strings?: string;
  readonly styles?: string;
  readonly properties?: string;
}

function workbook({ sheets, strings = '', styles = '', properties = '' }: Parts): Uint8Array {
  const names = Object.keys(sheets);
  const files = {
    'xl/workbook.xml': `<?xml version="1.0"?><workbook ${main}>${properties}<sheets>${names.map((name, index) => `<sheet name="${name}" sheetId="${index + 1}" state="hidden" r:id="rId${index + 1}"/>`).join('')}</sheets></workbook>`,
    'xl/_rels/workbook.xml.rels': `<Relationships>${names.map((_, index) => `<Relationship Id="rId${index + 1}" Type="worksheet" Target="worksheets/sheet${index + 1}.xml"/>`).join('')}</Relationships>`,
    'xl/sharedStrings.xml': `<sst ${main}>${strings}</sst>`,
    'xl/styles.xml': `<styleSheet ${main}>${styles}</styleSheet>`,
    ...Object.fromEntries(
      names.map((name, index) => [
        `xl/worksheets/sheet${index + 1}.xml`,
        `<worksheet ${main}>${sheets[name]}</worksheet>`,
      ]),
    ),
  };
  return zipSync(Object.fromEntries(Object.entries(files).map(([name, text]) => [name, strToU8(text)])));
}

const rowsOf = (parts: Parts) => readSheets(workbook(parts)).sheets.map(({ rows }) => rows);

test('reads shared strings, inline strings, numbers, formulas, truth values and errors', () => {
  const strings =
    '<si><t>name</t></si><si><r><t xml:space="preserve">add</t></r><r><t>ress</t></r><rPh><t>x</t></rPh></si><si><t>A &amp; B_x000D_</t></si>';
  const sheet = `<sheetData>
    <row r="2"><c r="A2" t="s"><v>0</v></c><c r="C2" t="s"><v>1</v></c></row>
    <row r="4" hidden="1"><c r="A4" t="s"><v>2</v></c><c r="B4" t="inlineStr"><is><t>in line</t></is></c><c r="C4"><f>1+1</f><v>2</v></c><c r="D4" t="b"><v>1</v></c><c r="E4" t="e"><v>#N/A</v></c><c r="F4" t="str"><f>x</f><v>text</v></c></row>
  </sheetData>`;
  const read = readSheets(workbook({ sheets: { 'Holding &amp; more': sheet, Empty: '<sheetData/>' }, strings }));
  expect(read).toEqual({
    encoding: '',
    format: 'xlsx',
    problems: [],
    sheets: [
      {
        name: 'Holding & more',
        kind: 'workbook',
        rows: [
          { line: 2, cells: ['name', '', 'address', '', '', ''] },
          { line: 4, cells: ['A & B\r', 'in line', '2', 'TRUE', '#N/A', 'text'] },
        ],
      },
    ],
  });
});

test('counts cells and rows that have no reference', () => {
  expect(
    rowsOf({
      sheets: { S: '<sheetData><row><c><v>1</v></c><c/><c><v>2</v></c></row><row><c><v>3</v></c></row></sheetData>' },
    }),
  ).toEqual([
    [
      { line: 1, cells: ['1', '', '2'] },
      { line: 2, cells: ['3', '', ''] },
    ],
  ]);
});

test.each([
  ['General', 0, '0.30000000000000004', '0.3'],
  ['General', 0, '1E-7', '0.0000001'],
  ['General', 0, '4294967295', '4294967295'],
  ['General', 0, '-32768', '-32768'],
  ['0000', 164, '64', '0064'],
  ['&quot;0x&quot;0000', 164, '64', '0x0064'],
  ['0&quot; V&quot;', 164, '230', '230 V'],
  ['0.00', 2, '0.1', '0.10'],
  ['0.00', 2, '0.125', '0.125'],
  ['#,##0', 3, '40001', '40001'],
  ['0%', 9, '0.1', '10%'],
  ['[Red]0.0;[Blue]-0.0', 164, '-2', '-2.0'],
  ['yyyy\\-mm\\-dd', 164, '45351', '2024-02-29'],
  ['[$-407]d. mmmm yyyy;@', 164, '45351', '2024-02-29'],
  ['short date', 14, '1', '1899-12-31'],
  ['date and time', 22, '45351.541666666664', '2024-02-29 13:00:00'],
  ['h:mm', 20, '0.5', '12:00:00'],
  ['@', 49, '0064', '64'],
])('shows a number of format %s (%s) as a spreadsheet does: %s', (code, id, value, shown) => {
  const styles = `<numFmts><numFmt numFmtId="164" formatCode="${code}"/></numFmts><cellStyleXfs><xf numFmtId="9"/></cellStyleXfs><cellXfs><xf numFmtId="0"/><xf numFmtId="${id}"/></cellXfs>`;
  expect(
    rowsOf({
      sheets: { S: `<sheetData><row r="1"><c r="A1" s="1"><v>${value}</v></c></row></sheetData>` },
      styles,
    })[0]?.[0]?.cells,
  ).toEqual([shown]);
});

test('dates of a workbook that counts from 1904', () => {
  const styles = '<cellXfs><xf numFmtId="14"/></cellXfs>';
  const sheets = { S: '<sheetData><row r="1"><c r="A1" s="0"><v>43889</v></c></row></sheetData>' };
  expect(rowsOf({ sheets, styles, properties: '<workbookPr date1904="1"/>' })[0]?.[0]?.cells).toEqual(['2024-02-29']);
});

test('merged cells: a title stays in one cell, others are repeated, and those from above are marked', () => {
  const cell = (reference: string, text: string) => `<c r="${reference}" t="inlineStr"><is><t>${text}</t></is></c>`;
  const sheet = `<sheetData>
    <row r="1">${cell('A1', 'Registers')}</row>
    <row r="2">${cell('A2', 'group')}${cell('B2', 'Address')}${cell('D2', 'name')}${cell('E2', 'unit')}</row>
    <row r="3">${cell('A3', 'AC')}${cell('B3', 'dec')}${cell('C3', 'hex')}${cell('D3', 'U')}${cell('E3', 'V')}</row>
    <row r="4">${cell('B4', '2')}${cell('D4', 'I')}</row>
    <row r="6">${cell('D6', 'P')}</row>
  </sheetData><mergeCells><mergeCell ref="A1:E1"/><mergeCell ref="B2:C2"/><mergeCell ref="A3:A6"/></mergeCells>`;
  expect(rowsOf({ sheets: { S: sheet } })[0]).toEqual([
    { line: 1, cells: ['Registers', '', '', '', ''] },
    { line: 2, cells: ['group', 'Address', 'Address', 'name', 'unit'] },
    { line: 3, cells: ['AC', 'dec', 'hex', 'U', 'V'] },
    { line: 4, cells: ['AC', '2', '', 'I', ''], merged: [0] },
    { line: 6, cells: ['AC', '', '', 'P', ''], merged: [0] },
  ]);
});

test('a merge of the whole sheet and a cell far to the right cost no more than they hold', () => {
  const rows = Array.from(
    { length: 40 },
    (_, index) => `<row r="${index + 1}"><c r="XFD${index + 1}"><v>1</v></c></row>`,
  ).join('');
  const read = readSheets(
    workbook({
      sheets: { S: `<sheetData>${rows}</sheetData><mergeCells><mergeCell ref="A1:XFD1048576"/></mergeCells>` },
    }),
    '',
    { ...usualLimits, cells: 400_000 },
  );
  expect(read.problems.map(({ code }) => code)).toContain('too-many-cells');
});

test('what unpacks to more than a file may hold is refused', () => {
  const limits = { ...usualLimits, bytes: 200_000 };
  const problemsOf = (bytes: Uint8Array) => readSheets(bytes, '', limits).problems;
  const zeros = new Uint8Array(21_000);
  const member = gzipSync(zeros);
  const members = (count: number) => Uint8Array.from(Array.from({ length: count }, () => [...member]).flat());
  const tooLarge = [{ code: 'too-large', most: 200_000 }];
  expect(problemsOf(members(9))).not.toEqual(tooLarge);
  expect(problemsOf(members(10))).toEqual(tooLarge);
  const archive = zipSync({ 'xl/sharedStrings.xml': zeros });
  expect(problemsOf(listedTimes(archive, 9))).not.toEqual(tooLarge);
  expect(problemsOf(listedTimes(archive, 10))).toEqual(tooLarge);
  // All that a piece of a file unpacks to is refused before the next one is unpacked.
  expect(problemsOf(gzipSync(new Uint8Array(2_000_000)))).toEqual(tooLarge);
});

/** An archive whose directory has the one entry of this archive several times. */
function listedTimes(archive: Uint8Array, times: number): Uint8Array {
  const end = archive.length - 22;
  const directory = new DataView(archive.buffer, archive.byteOffset).getUint32(end + 16, true);
  const entry = archive.subarray(directory, end);
  const listed = Uint8Array.from([
    ...archive.subarray(0, directory),
    ...Array.from({ length: times }, () => [...entry]).flat(),
    ...archive.subarray(end),
  ]);
  new DataView(listed.buffer).setUint16(listed.length - 12, times, true);
  return listed;
}

test('reads what gzip packed, and says what other containers are', () => {
  expect(readSheets(gzipSync(strToU8('name,address\nA,0\n')), 'map.csv.gz').sheets[0]?.rows).toHaveLength(2);
  expect(readSheets(gzipSync(strToU8('name,address\nA,0\n')).subarray(0, 20)).problems[0]?.code).toBe('unreadable');
  expect(readSheets(strToU8('%PDF-1.7 ...')).problems).toEqual([{ code: 'not-a-table', format: 'pdf' }]);
  expect(readSheets(zipSync({ 'readme.txt': strToU8('x') })).problems).toEqual([
    { code: 'not-a-table', format: 'zip' },
  ]);
});

test('a damaged workbook is read in part or refused', () => {
  const whole = workbook({ sheets: { S: '<sheetData><row r="1"><c r="A1"><v>1</v></c></row></sheetData>' } });
  fc.assert(
    fc.property(fc.nat(whole.length - 1), fc.nat(255), fc.nat(whole.length), (at, byte, length) => {
      const damaged = Uint8Array.from(whole);
      damaged[at] = byte;
      expect(Array.isArray(readSheets(damaged.subarray(0, length)).sheets)).toBe(true);
      expect(Array.isArray(readSheets(damaged).sheets)).toBe(true);
    }),
  );
});

const escaped = (text: string) => text.replaceAll('&', '&amp;').replaceAll('<', '&lt;').replaceAll('"', '&quot;');

test('every cell of a table comes out again', () => {
  const cell = fc.string({ minLength: 1, maxLength: 6, unit: fc.constantFrom(...'aB0é&<">|;,') });
  fc.assert(
    fc.property(fc.array(fc.tuple(cell, cell, cell), { minLength: 1, maxLength: 8 }), (table) => {
      const strings = table
        .flat()
        .map((text) => `<si><t>${escaped(text)}</t></si>`)
        .join('');
      const rows = table.map(
        (cells, row) =>
          `<row r="${row + 1}">${cells.map((_, column) => `<c r="${'ABC'[column]}${row + 1}" t="s"><v>${row * 3 + column}</v></c>`).join('')}</row>`,
      );
      expect(
        rowsOf({ sheets: { S: `<sheetData>${rows.join('')}</sheetData>` }, strings })[0]?.map(({ cells }) => cells),
      ).toEqual(table);
    }),
  );
});
