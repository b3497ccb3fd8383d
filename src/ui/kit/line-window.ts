/** Above this height in pixels browsers lose count: Firefox draws nothing at 28,000,000. */
const TALLEST = 7_000_000;
/** Lines drawn above and below those in sight. */
const BEYOND = 8;

/** A long list of lines of one height, in the box that scrolls it; all lengths are in pixels. */
export interface LineBox {
  readonly count: number;
  readonly line: number;
  /** How much of the box shows lines. */
  readonly view: number;
}

/** The height of what scrolls. Lists that would be too tall for a browser are scaled: a pixel scrolled is more than one of the list. */
export const scrollHeight = ({ count, line }: LineBox): number => Math.min(count * line, TALLEST);

/** How many pixels of the list a pixel scrolled is. */
export function scrollScale(box: LineBox): number {
  const shown = scrollHeight(box);
  return shown < TALLEST || shown <= box.view ? 1 : (box.count * box.line - box.view) / (shown - box.view);
}

/** The lines to be drawn, from `from` to before `to`, and where in what scrolls the line 0 would stand. */
export function linesInSight(box: LineBox, scrolled: number): { from: number; to: number; origin: number } {
  const offset = scrolled * scrollScale(box);
  const first = Math.floor(offset / box.line);
  const past = Math.ceil((offset + box.view) / box.line);
  return {
    from: Math.max(0, Math.min(first, box.count) - BEYOND),
    to: Math.max(0, Math.min(box.count, past + BEYOND)),
    origin: scrolled - offset,
  };
}

/** Where to scroll so that a line is in sight, moving no more than needed. */
export function scrollToLine(box: LineBox, scrolled: number, index: number): number {
  const scale = scrollScale(box);
  const offset = scrolled * scale;
  const top = index * box.line;
  const bottom = top + box.line - box.view;
  // A browser keeps whole pixels only: where a pixel is several of the list, the line is a little further inside.
  if (top < offset || box.line > box.view) return Math.floor(top / scale);
  return bottom > offset ? Math.ceil(bottom / scale) : scrolled;
}

/** Where a key leads from a line; `undefined` for keys that lead nowhere. */
export function lineForKey(key: string, { count, line, view }: LineBox, from: number): number | undefined {
  const page = Math.max(1, Math.floor(view / line));
  const to = new Map([
    ['ArrowDown', from + 1],
    ['ArrowUp', from - 1],
    ['PageDown', from + page],
    ['PageUp', from - page],
    ['Home', 0],
    ['End', count - 1],
  ]).get(key);
  return to === undefined ? undefined : Math.max(0, Math.min(count - 1, to));
}
