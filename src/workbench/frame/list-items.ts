/** Longest list that any field can hold. */
const MOST = 2000;

/** The items of a list as typed: each keeps its notation. A list that cannot be read is taken apart at its separators. */
export const itemsOf = (text: string): string[] => text.split(/[\s,;]+/).filter((word) => word !== '');

/** The list with the item at `from` moved to `to`; the same list if there is no such item. */
export function moved(items: readonly string[], from: number, to: number): readonly string[] {
  const item = items[from];
  return item === undefined ? items : items.toSpliced(from, 1).toSpliced(to, 0, item);
}

/** A list of `count` items, at most 2000: `value`, and each following one `step` more. */
export const filled = ({
  count,
  value,
  step,
}: {
  readonly count: number;
  readonly value: number;
  readonly step: number;
}): readonly string[] =>
  Array.from({ length: Math.max(0, Math.min(count, MOST)) }, (_, index) => String(value + index * step));
