import type { Sheet, SheetRow } from './sheet.ts';

/** The line below the header of a table, with or without bars at its ends. */
const RULE = /^\s*\|?\s*:?-+:?\s*(?:\|\s*:?-+:?\s*)+\|?\s*$|^\s*\|\s*:?-+:?\s*\|\s*$/;
/** A border of a table that is drawn with characters. */
const BORDER = /^\s*[+|][-+=|: ]*[-=][-+=|: ]*[+|]\s*$/;
const BARRED = /^\s*\|.*\|\s*$/;
const HEADING = /^\s*(?:#{1,6}\s+(.+?)\s*#*|\*\*(.+)\*\*:?|(\S.{0,78}):)\s*$/;

/** Whether a text has a table of Markdown, or one that is drawn with bars. */
export function looksLikeMarkdown(text: string): boolean {
  const lines = text.split(/\r\n|\r|\n/);
  return lines.some((line) => RULE.test(line)) || lines.filter((line) => BARRED.test(line)).length > 1;
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
  const lines = text.split(/\r\n|\r|\n/);
  for (const [index, line] of lines.entries()) {
    if (RULE.test(line) || BORDER.test(line)) continue;
    const inTable = BARRED.test(line) || (line.includes('|') && (rows.length > 0 || RULE.test(lines[index + 1] ?? '')));
    if (inTable) {
      rows.push({ line: index + 1, cells: cellsOf(line) });
      continue;
    }
    end();
    const found = HEADING.exec(line);
    if (found) heading = (found[1] ?? found[2] ?? found[3] ?? '').trim();
  }
  end();
  return sheets;
}

function cellsOf(line: string): string[] {
  const parts = line.trim().replace(/\\\|/g, '\uE000').split('|');
  if (line.trimStart().startsWith('|')) parts.shift();
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
