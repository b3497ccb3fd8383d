import { readFileText } from '../../notation/index.ts';
import { attributeNamed, scanMarkup } from './markup.ts';
import { type Merge, type RawRow, withMerges } from './merged.ts';
import type { Sheet, SheetLimits, SheetProblem } from './sheet.ts';
import { shownNumber } from './shown-number.ts';

type Files = ReadonlyMap<string, Uint8Array>;

const WIDEST = 16_384;
const LONGEST_FORMAT = 255;

const idOf = attributeNamed('Id');
const targetOf = attributeNamed('Target');
const nameOf = attributeNamed('name');
const relationOf = attributeNamed('(?<=:)id');
const date1904Of = attributeNamed('date1904');
const formatIdOf = attributeNamed('numFmtId');
const codeOf = attributeNamed('formatCode');
const referenceOf = attributeNamed('r');
const typeOf = attributeNamed('t');
const styleOf = attributeNamed('s');
const rangeOf = attributeNamed('ref');

/** The files of a workbook that are read. */
export const isPartOfWorkbook = (name: string): boolean =>
  /^xl\/[^/]*\.xml$|^xl\/(?:_rels|worksheets)\/[^/]*\.(?:xml|rels)$/i.test(name);

export const isWorkbook = (files: Files): boolean => files.has('xl/workbook.xml');

/** The worksheets of a workbook (ECMA-376-1 18), hidden ones too, with every cell as its format shows it. */
export function readWorkbook(files: Files, problems: SheetProblem[], limits: SheetLimits): readonly Sheet[] {
  const text = (name: string) => {
    const bytes = files.get(name);
    return (bytes && readFileText(bytes)?.text) ?? '';
  };
  const strings = sharedStrings(text('xl/sharedStrings.xml'));
  const formats = cellFormats(text('xl/styles.xml'));
  const targets = new Map<string, string>();
  scanMarkup(
    text('xl/_rels/workbook.xml.rels'),
    {
      ...quiet,
      open: (name, attributes) => {
        if (name === 'Relationship') targets.set(idOf(attributes), targetOf(attributes));
      },
    },
    'xml',
  );
  const sheets: { name: string; path: string }[] = [];
  let from1904 = false;
  scanMarkup(
    text('xl/workbook.xml'),
    {
      ...quiet,
      open: (name, attributes) => {
        if (name === 'workbookPr') from1904 = /^(?:1|true)$/.test(date1904Of(attributes));
        if (name !== 'sheet') return;
        const target = targets.get(relationOf(attributes)) ?? '';
        sheets.push({ name: nameOf(attributes), path: target.startsWith('/') ? target.slice(1) : `xl/${target}` });
      },
    },
    'xml',
  );
  return sheets.flatMap(({ name, path }): Sheet[] => {
    const rows = worksheet(text(path), strings, formats, from1904, problems, limits);
    return rows.length > 0 ? [{ name, kind: 'workbook', rows }] : [];
  });
}

const quiet = { open: () => undefined, close: () => undefined, text: () => undefined };

function sharedStrings(xml: string): readonly string[] {
  const strings: string[] = [];
  let parts = '';
  let inText = false;
  let inPhonetic = false;
  scanMarkup(
    xml,
    {
      open: (name) => {
        if (name === 'si') parts = '';
        if (name === 't') inText = true;
        if (name === 'rPh') inPhonetic = true;
      },
      close: (name) => {
        if (name === 'si') strings.push(unescaped(parts));
        if (name === 't') inText = false;
        if (name === 'rPh') inPhonetic = false;
      },
      text: (text) => {
        if (inText && !inPhonetic) parts += text;
      },
    },
    'xml',
  );
  return strings;
}

/** Characters that XML cannot hold are written `_x000D_`. */
const unescaped = (text: string): string =>
  text.includes('_x')
    ? text.replace(/_x([\dA-F]{4})_/gi, (_whole, code: string) => String.fromCharCode(Number.parseInt(code, 16)))
    : text;

/** The format of numbers for each style of cells. */
function cellFormats(xml: string): readonly (number | string)[] {
  const own = new Map<number, string>();
  const formats: (number | string)[] = [];
  let inCells = false;
  scanMarkup(
    xml,
    {
      ...quiet,
      open: (name, attributes) => {
        const id = Number(formatIdOf(attributes));
        if (name === 'numFmt') own.set(id, codeOf(attributes).slice(0, LONGEST_FORMAT));
        if (name === 'cellXfs') inCells = true;
        if (name === 'xf' && inCells) formats.push(own.get(id) ?? id);
      },
      close: (name) => {
        if (name === 'cellXfs') inCells = false;
      },
    },
    'xml',
  );
  return formats;
}

function worksheet(
  xml: string,
  strings: readonly string[],
  formats: readonly (number | string)[],
  from1904: boolean,
  problems: SheetProblem[],
  limits: SheetLimits,
) {
  const rows: RawRow[] = [];
  const merges: Merge[] = [];
  let cell = { column: 0, type: '', style: 0 };
  let column = 0;
  let left = limits.cells;
  let characters = limits.bytes;
  let value = '';
  let listens = false;
  const row = () => rows.at(-1);
  scanMarkup(
    xml,
    {
      open: (name, attributes) => {
        if (name === 'row') {
          const line = Number(referenceOf(attributes)) || (row()?.line ?? 0) + 1;
          rows.push({ line, cells: [] });
          column = 0;
        } else if (name === 'c') {
          const at = columnOf(referenceOf(attributes)) ?? column;
          cell = { column: at, type: typeOf(attributes) || 'n', style: Number(styleOf(attributes)) };
          column = at + 1;
          value = '';
        } else if (name === 'v' || name === 't') listens = true;
        else if (name === 'mergeCell') {
          const merge = mergeOf(rangeOf(attributes));
          if (merge) merges.push(merge);
        }
      },
      close: (name) => {
        if (name === 'v' || name === 't') listens = false;
        if (name !== 'c' || value === '' || left < 0) return;
        const cells = row()?.cells ?? [];
        left -= Math.max(1, cell.column + 1 - cells.length);
        if (left < 0) return;
        while (cells.length < cell.column) cells.push('');
        const text = shown(value);
        characters -= text.length;
        if (characters >= 0) cells[cell.column] = text;
      },
      text: (text) => {
        if (listens) value += text;
      },
    },
    'xml',
  );
  if (left < 0) problems.push({ code: 'too-many-cells', most: limits.cells });
  if (characters < 0) problems.push({ code: 'too-large', most: limits.bytes });
  return withMerges(rows, merges, problems, limits.cells);

  function shown(text: string): string {
    if (cell.type === 's') return strings[Number(text)] ?? '';
    if (cell.type === 'b') return text === '1' ? 'TRUE' : 'FALSE';
    if (cell.type === 'n') return shownNumber(text, formats[cell.style] ?? 0, from1904);
    return unescaped(text);
  }
}

/** The column of a reference such as `AB12`, from 0. */
function columnOf(reference: string): number | undefined {
  const [letters = ''] = /^[A-Z]{1,3}/i.exec(reference) ?? [];
  if (letters === '') return undefined;
  const column = [...letters.toUpperCase()].reduce((sum, letter) => sum * 26 + letter.charCodeAt(0) - 64, 0) - 1;
  return column < WIDEST ? column : undefined;
}

function mergeOf(reference: string): Merge | undefined {
  const [first = '', last = ''] = reference.split(':');
  const [column, lastColumn] = [columnOf(first), columnOf(last)];
  const [line, lastLine] = [first, last].map((each) => Number(/^[A-Z]{1,3}(\d{1,7})$/i.exec(each)?.[1] ?? 0));
  if (column === undefined || lastColumn === undefined || !line || !lastLine) return undefined;
  return { line, lastLine, column, columns: lastColumn - column + 1 };
}
