import papa from 'papaparse';
import { type Profile, type ProfileReading, readTable, type TableRow, writeTable } from '../../devices/index.ts';

const DELIMITERS = [',', ';', '\t', '|'];
/** How often reading begins anew behind a quote that is not closed. */
const MOST_RESTARTS = 20;

/** The text of a CSV file, with the mark by which spreadsheets know UTF-8. */
export const writeCsv = (profile: Profile): string => `\uFEFF${papa.unparse(writeTable(profile))}\r\n`;

/** Reads a CSV file by the delimiter with which it has the most columns that are known. */
export function readCsv(text: string, name: string): ProfileReading {
  const plain = text.replace(/^\uFEFF/, '');
  const readings = DELIMITERS.map((delimiter) => readTable(rowsOf(plain, delimiter), name));
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
export function rowsOf(text: string, delimiter: string): TableRow[] {
  const rows: TableRow[] = [];
  let rest = text;
  let line = 1;
  for (let restarts = 0; rest !== ''; restarts++) {
    const from = line;
    let begin = 0;
    let openAt: number | undefined;
    for (const { cells, open, end } of parse(rest, delimiter)) {
      rows.push({ line, cells, ...(open ? { open } : {}) });
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

interface Parsed {
  readonly cells: readonly string[];
  readonly open: boolean;
  readonly end: number;
}

function parse(text: string, delimiter: string): Parsed[] {
  const parsed: Parsed[] = [];
  papa.parse(text, {
    delimiter,
    step: ({ data, errors, meta }) => {
      parsed.push({ cells: data, open: errors.some(({ type }) => type === 'Quotes'), end: meta.cursor });
    },
  });
  return parsed;
}

const linesIn = (text: string): number => text.match(/\r\n|\r|\n/g)?.length ?? 0;

/** Where the line after a place begins. */
function lineEnd(text: string, from: number): number {
  const found = /\r\n|\r|\n/g;
  found.lastIndex = from;
  return found.exec(text) === null ? text.length : found.lastIndex;
}
