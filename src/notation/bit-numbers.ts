/** Numbers of the bits of a register, or the first word that is not one. */
export type BitNumbers =
  | { readonly kind: 'bits'; readonly mask: number }
  | { readonly kind: 'wrong'; readonly text: string };

const HIGHEST = 15;

/** The bits of a register as people number them, bit 0 the lowest: `0, 3, 8-11`. Answers them as a 16-bit mask. */
export function readBitNumbers(text: string): BitNumbers {
  let mask = 0;
  for (const [word] of text.replace(/\s*[-–…]\s*|\.\./g, '-').matchAll(/[^\s,;]+/g)) {
    const [, low = '', high = low] = /^(\d{1,2})(?:-(\d{1,2}))?$/.exec(word) ?? [];
    if (low === '' || Number(low) > HIGHEST || Number(high) > HIGHEST) return { kind: 'wrong', text: word };
    const [first, last] = [Number(low), Number(high)].toSorted((a, b) => a - b) as [number, number];
    for (let bit = first; bit <= last; bit++) mask |= 1 << bit;
  }
  return { kind: 'bits', mask };
}

/** The bits that are 1 in a 16-bit mask, runs of three and more by their ends: `0, 3, 8-11`. */
export function formatBitNumbers(mask: number): string {
  const runs: [number, number][] = [];
  for (let bit = 0; bit <= HIGHEST; bit++) {
    if ((mask & (1 << bit)) === 0) continue;
    const run = runs.at(-1);
    if (run?.[1] === bit - 1) run[1] = bit;
    else runs.push([bit, bit]);
  }
  const write = ([first, last]: [number, number]) =>
    last - first > 1 ? `${first}-${last}` : first === last ? String(first) : `${first}, ${last}`;
  return runs.map(write).join(', ');
}
