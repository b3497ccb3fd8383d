/** Lines of one height, of which a few have more below them; all lengths are in pixels. */
export interface TallLines {
  readonly count: number;
  readonly line: number;
  /** What the lines have below them, by their number. */
  readonly below: ReadonlyMap<number, number>;
}

/** How far from the top a line begins; that of the line behind the last is the height of all. */
export function topOf({ line, below }: TallLines, index: number): number {
  let top = index * line;
  for (const [at, height] of below) if (at < index) top += height;
  return top;
}

/** The line that stands at a distance from the top: the last one if it is below all of them. */
export function lineAt({ count, line, below }: TallLines, top: number): number {
  let left = top;
  for (const [at, height] of [...below].sort(([one], [other]) => one - other)) {
    if (left < (at + 1) * line) break;
    left = Math.max((at + 1) * line - 1, left - height);
  }
  return Math.max(0, Math.min(count - 1, Math.floor(left / line)));
}
