import { type Profile, type ProfileReading, readTable, type TableRow, writeTable } from '../../devices/index.ts';
import { unguardedCell, writeCsvFile } from '../../notation/index.ts';

/** A row as it was parsed: `open` if a quote in it is not closed; `end` is where it ends in the text. */
export interface ParsedRow {
  readonly cells: readonly string[];
  readonly open: boolean;
  readonly end: number;
}

/** Takes a text apart by a delimiter, into rows in their order. */
export type ParseCsv = (text: string, delimiter: string) => readonly ParsedRow[];

const DELIMITERS = [',', ';', '\t', '|'];
/** How often reading begins again after a quote that is not closed. */
const MOST_RESTARTS = 20;

/** The text of a CSV file, with the mark by which spreadsheets know UTF-8. */
export const writeProfileCsv = (profile: Profile): string => writeCsvFile(writeTable(profile), 'marked');

/** Reads a CSV file by the delimiter with which it has the most columns that are known. */
export function readProfileCsv(text: string, name: string, parse: ParseCsv): ProfileReading {
  const plain = text.replace(/^\uFEFF/, '');
  const readings = DELIMITERS.map((delimiter) => readTable(csvRows(plain, delimiter, parse), name));
  const wrong = ({ faults }: ProfileReading) => faults.length;
  const [first, ...others] = readings.toSorted(
    (a, b) => b.profile.registers.length - a.profile.registers.length || wrong(a) - wrong(b),
  );
  const withHeader = [first, ...others].find(
    (reading) => reading && !reading.faults.some(({ code }) => code === 'header-missing'),
  );
  return (withHeader ?? first) as ProfileReading;
}

/** The rows of a text, each with its line. What an open quote swallowed is read again from the next line on. */
export function csvRows(text: string, delimiter: string, parse: ParseCsv): TableRow[] {
  const rows: TableRow[] = [];
  let rest = text;
  let line = 1;
  for (let restarts = 0; rest !== ''; restarts++) {
    const from = line;
    let begin = 0;
    let openAt: number | undefined;
    for (const { cells, open, end } of parse(rest, delimiter)) {
      rows.push({ line, cells: cells.map(unguardedCell), ...(open ? { open } : {}) });
      if (open && restarts < MOST_RESTARTS && lineEnd(rest, begin) < end) {
        openAt = begin;
        break;
      }
      line += linesIn(rest.slice(begin, end));
      begin = end;
    }
    if (openAt === undefined) break;
    line = from + linesIn(rest.slice(0, openAt)) + 1;
    rest = rest.slice(lineEnd(rest, openAt));
  }
  return rows;
}

const linesIn = (text: string): number => text.match(/\r\n|\r|\n/g)?.length ?? 0;

/** Where the line after a place begins. */
function lineEnd(text: string, from: number): number {
  const found = /\r\n|\r|\n/g;
  found.lastIndex = from;
  return found.exec(text) === null ? text.length : found.lastIndex;
}
