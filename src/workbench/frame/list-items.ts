import { readBits, readNumbers } from '../../notation/index.ts';

/** Longest list that any field can hold. */
const MOST = 2000;

/** The items of a list as typed: each keeps its notation. A list that cannot be read is taken apart at its separators. */
export function itemsOf(text: string, bits: boolean): string[] {
  const list = bits ? readBits(text) : readNumbers(text);
  if (bits && list.kind === 'list') return list.items.map(String);
  return text.split(/[\s,;]+/).filter((word) => word !== '');
}

/** The list with the item at `from` moved to `to`; the same list if there is no such item. */
export function moved(items: readonly string[], from: number, to: number): readonly string[] {
  const item = items[from];
  return item === undefined ? items : items.toSpliced(from, 1).toSpliced(to, 0, item);
}

/** A list of `count` items, at most 2000: `value`, and each following one `step` more. Bits are all 1, or all 0 if `value` is. */
export const filled = (
  { count, value, step }: { readonly count: number; readonly value: number; readonly step: number },
  bits: boolean,
): readonly string[] =>
  Array.from({ length: Math.max(0, Math.min(count, MOST)) }, (_, index) =>
    String(bits ? Number(value !== 0) : value + index * step),
  );
