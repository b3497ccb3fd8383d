import papa from 'papaparse';
import { type ScanFinding, type ScanOrder, supports } from '../../bus/index.ts';
import { scanWords as words } from './language.ts';

type Column = keyof typeof words.columns;

/** The columns of a table of findings. */
export function columnsOf({ what }: ScanOrder): readonly Column[] {
  switch (what) {
    case 'units':
      return ['unit', 'hex', 'line', 'answer', 'time'];
    case 'functions':
      return ['code', 'name', 'supported', 'answer', 'time'];
    case 'addresses':
      return ['addresses', 'hex', 'count', 'answer'];
  }
}

/** The cells of a finding, in the order of the columns. */
export function cellsOf(found: ScanFinding): readonly string[] {
  switch (found.what) {
    case 'unit':
      return [
        String(found.unit),
        words.hexUnit(found.unit),
        words.line(found.settings),
        words.answer(found),
        words.time(found),
      ];
    case 'not-opened':
      return ['', '', words.line(found.settings), words.notOpened, ''];
    case 'function':
      return [
        words.functionCode(found.functionCode),
        words.functionName(found.functionCode),
        words.supported[supports(found)],
        words.answer(found),
        words.time(found),
      ];
    case 'addresses':
      return [
        words.range(found.first, found.last),
        words.hexRange(found.first, found.last),
        String(found.last - found.first + 1),
        words.answer(found),
      ];
  }
}

const tableOf = (order: ScanOrder, found: readonly ScanFinding[]): string[][] => [
  columnsOf(order).map((column) => words.columns[column]),
  ...found.map((one) => [...cellsOf(one)]),
];

/** The findings as a table with commas. */
export const asCsv = (order: ScanOrder, found: readonly ScanFinding[]): string =>
  `${papa.unparse([...tableOf(order, found)])}\r\n`;

/** The findings as a table for a forum. */
export function asMarkdown(order: ScanOrder, found: readonly ScanFinding[]): string {
  const [head = [], ...rows] = tableOf(order, found);
  const line = (cells: readonly string[]) => `| ${cells.map((cell) => cell.replaceAll('|', '\\|')).join(' | ')} |\n`;
  return [head, head.map(() => '---'), ...rows].map(line).join('');
}
