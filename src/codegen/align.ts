import type { Lines } from './written.ts';

/** A line, with a comment in the language's marks, or `''`. */
export interface Row {
  readonly text: string;
  readonly mark: string;
  readonly spans?: readonly string[] | undefined;
  /** Whether the lines below stand in another column; only in sections. */
  readonly ends?: boolean | undefined;
}

const WIDEST = 112;
const WIDEST_ALIGNED = 72;

/** Lines with their comments after them, one below the other; a comment that finds no room stands before its line. */
export function inOneColumn(lines: Lines, rows: readonly Row[], gap: string): void {
  const column = Math.max(
    0,
    ...rows.flatMap(({ text, mark }) => (mark !== '' && text.length <= WIDEST_ALIGNED ? [text.length] : [])),
  );
  for (const { text, mark, spans } of rows) {
    const line = text.padEnd(column) + gap + mark;
    if (mark !== '' && line.length > WIDEST) lines.add(mark, spans).add(text, spans);
    else lines.add(mark === '' ? text : line, spans);
  }
}

/** The same, but a line without a comment after it ends a column, as gofmt has it. */
export function inSections(lines: Lines, rows: readonly Row[], gap: string): void {
  const isAside = (row: Row | undefined): boolean =>
    row !== undefined && row.mark !== '' && row.text.length + row.mark.length <= WIDEST;
  let column = 0;
  for (const [at, row] of rows.entries()) {
    const { text, mark, spans } = row;
    if (isAside(row)) {
      if (!isAside(rows[at - 1]) || rows[at - 1]?.ends) {
        const end = rows.findIndex((other, index) => index >= at && (other.ends || !isAside(rows[index + 1])));
        column = Math.max(...rows.slice(at, end + 1).map((other) => other.text.length));
      }
      lines.add(text.padEnd(column) + gap + mark, spans);
    } else {
      if (mark !== '') lines.add(mark, spans);
      lines.add(text, spans);
    }
  }
}

/** Texts with what stands before the mark made as wide in all of them. */
export function inColumns(texts: readonly string[], mark: string): readonly string[] {
  const column = Math.max(...texts.map((text) => text.indexOf(mark)));
  return texts.map((text) => text.slice(0, text.indexOf(mark)).padEnd(column) + text.slice(text.indexOf(mark)));
}
