import { type LinkSettings, type ScanAnswer, type ScanFinding, type ScanOrder, supports } from '../../bus/index.ts';
import { writeCsvFile, writeTableText } from '../../notation/index.ts';

/** The columns that a table of findings can have. */
export type ScanColumn =
  | 'unit'
  | 'hex'
  | 'line'
  | 'answer'
  | 'time'
  | 'code'
  | 'name'
  | 'supported'
  | 'addresses'
  | 'count';

/** The texts of a table of findings. */
export interface FindingWords {
  readonly columns: Readonly<Record<ScanColumn, string>>;
  readonly hexUnit: (unit: number) => string;
  readonly line: (settings: LinkSettings) => string;
  readonly answer: (answer: ScanAnswer) => string;
  /** Of a unit: that it is there. */
  readonly unitAnswer: (answer: ScanAnswer) => string;
  readonly time: (answer: ScanAnswer) => string;
  readonly notOpened: string;
  readonly functionCode: (code: number) => string;
  readonly functionName: (code: number) => string;
  readonly supported: Readonly<Record<ReturnType<typeof supports>, string>>;
  readonly range: (first: number, last: number) => string;
  readonly hexRange: (first: number, last: number) => string;
}

/** The columns of a table of findings. */
export function findingColumns({ what }: ScanOrder): readonly ScanColumn[] {
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
export function findingCells(found: ScanFinding, words: FindingWords): readonly string[] {
  switch (found.what) {
    case 'unit':
      return [
        String(found.unit),
        words.hexUnit(found.unit),
        words.line(found.settings),
        words.unitAnswer(found),
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

const tableOf = (order: ScanOrder, found: readonly ScanFinding[], words: FindingWords): (readonly string[])[] => [
  findingColumns(order).map((column) => words.columns[column]),
  ...found.map((one) => findingCells(one, words)),
];

/** The findings as a table with commas. */
export const findingsAsCsv = (order: ScanOrder, found: readonly ScanFinding[], words: FindingWords): string =>
  writeCsvFile(tableOf(order, found, words));

/** The findings as a table for a forum. */
export const findingsAsMarkdown = (order: ScanOrder, found: readonly ScanFinding[], words: FindingWords): string =>
  `${writeTableText(tableOf(order, found, words), 'markdown')}\n`;
