import type { SheetProblem, SheetRow } from './sheet.ts';

/** A row of cells before it is filled up to the width of its table. */
export interface RawRow {
  readonly line: number;
  readonly cells: string[];
}

/** A cell that covers others; rows by their line, columns from 0. */
export interface Merge {
  readonly line: number;
  readonly lastLine: number;
  readonly column: number;
  readonly columns: number;
}

/**
 * The rows with the text of merged cells in all the cells they cover, and those that come from a row above marked. A cell over
 * half of the table or more is a title or the name of a group: its text stays in its first cell.
 */
export function withMerges(
  rows: readonly RawRow[],
  merges: readonly Merge[],
  problems: SheetProblem[],
  most: number,
): readonly SheetRow[] {
  const width = rows.reduce((most, { cells }) => Math.max(most, cells.length), 0);
  if (width * rows.length > most) {
    problems.push({ code: 'too-many-cells', most });
    return [];
  }
  let left = most;
  const indexOf = new Map(rows.map(({ line }, index) => [line, index]));
  const from = new Map<number, Set<number>>();
  for (const { line, lastLine, column, columns } of merges) {
    const first = indexOf.get(line);
    if (first === undefined) continue;
    const text = rows[first]?.cells[column] ?? '';
    const covered = columns * 2 >= width && columns > 1 ? 1 : columns;
    for (let index = first; index < rows.length && (rows[index]?.line ?? 0) <= lastLine; index++) {
      if (left-- < 0) break;
      for (let each = column; each < Math.min(column + covered, width); each++) {
        if (left-- < 0) break;
        const cells = rows[index]?.cells ?? [];
        if ((cells[each] ?? '') !== '' || text === '') continue;
        while (cells.length < each) cells.push('');
        cells[each] = text;
        if (index > first) from.set(index, (from.get(index) ?? new Set()).add(each));
      }
      if (left < 0) break;
    }
  }
  if (left < 0) problems.push({ code: 'too-many-cells', most });
  return rows.flatMap(({ line, cells }, index): SheetRow[] => {
    if (cells.every((cell) => cell.trim() === '')) return [];
    while (cells.length < width) cells.push('');
    const merged = from.get(index);
    return [{ line, cells, ...(merged ? { merged: [...merged].sort((one, other) => one - other) } : {}) }];
  });
}
