import type { Sheet, SheetRow } from './sheet.ts';

/** The line below the header of a table, with or without bars at its ends; of a line without blanks at its ends. */
const RULE = /^\|?\s*:?-+:?\s*(?:\|\s*:?-+:?\s*)+\|?$|^\|\s*:?-+:?\s*\|$/;
/** A border of a table that is drawn with characters. */
const BORDER = /^[+|][-+=|: ]*[+|]$/;
const LONGEST_HEADING = 100;

const isRule = (line: string): boolean => RULE.test(line) || (BORDER.test(line) && /[-=]/.test(line));
const isBarred = (line: string): boolean => line.length > 1 && line.startsWith('|') && line.endsWith('|');

/** The text of a line that may be the heading of what follows. */
function headingOf(line: string): string | undefined {
  if (line.length > LONGEST_HEADING) return undefined;
  const [, marked, bold, named] = /^(?:#{1,6}\s+(.+)|\*\*(.+)\*\*:?|(\S.*):)$/.exec(line) ?? [];
  return (marked?.replace(/\s*#+$/, '') ?? bold ?? named)?.trim();
}

const linesOf = (text: string): string[] => text.split(/\r\n|\r|\n/).map((line) => line.trim());

/** Whether a text has a table of Markdown, or one that is drawn with bars. */
export function looksLikeMarkdown(text: string): boolean {
  const lines = linesOf(text);
  return lines.some((line) => RULE.test(line)) || lines.filter(isBarred).length > 1;
}

/** The tables of a text of Markdown, each with the heading above it. */
export function readMarkdown(text: string): readonly Sheet[] {
  const sheets: Sheet[] = [];
  let heading = '';
  let rows: SheetRow[] = [];
  const end = () => {
    if (rows.length > 0) sheets.push({ ...(heading === '' ? {} : { name: heading }), kind: 'markdown', rows });
    if (rows.length > 0) heading = '';
    rows = [];
  };
  const lines = linesOf(text);
  for (const [index, line] of lines.entries()) {
    if (isRule(line)) continue;
    if (isBarred(line) || (line.includes('|') && (rows.length > 0 || RULE.test(lines[index + 1] ?? '')))) {
      rows.push({ line: index + 1, cells: cellsOf(line) });
      continue;
    }
    end();
    heading = headingOf(line) ?? heading;
  }
  end();
  return sheets;
}

function cellsOf(line: string): string[] {
  const parts = line.replace(/\\\|/g, '\uE000').split('|');
  if (line.startsWith('|')) parts.shift();
  if (parts.length > 1 && parts.at(-1)?.trim() === '') parts.pop();
  return parts.map((part) => plainText(part.replaceAll('\uE000', '|').trim()));
}

/** The text of a cell without the signs around the whole of it and the targets of links, and with its line breaks. */
const plainText = (cell: string): string =>
  cell
    .replace(/<br\s*\/?>/gi, '\n')
    .replace(/!?\[([^\]]*)\]\([^)\s]*\)/g, '$1')
    .replace(/^(`+)([^`]+)\1$/, '$2')
    .replace(/^(\*\*|__)(.+)\1$/, '$2')
    .trim();
