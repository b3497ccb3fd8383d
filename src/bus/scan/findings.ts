import { isSameLine } from '../link/link.ts';
import type { ScanAnswer, ScanFinding } from './scan-news.ts';

/** Adds what was found: it joins its neighbour, or takes the place of what was told of the same before. */
export function addFinding(found: ScanFinding[], next: ScanFinding): void {
  if (next.what === 'addresses') {
    const last = found.at(-1);
    const joins =
      last?.what === 'addresses' &&
      last.last + 1 === next.first &&
      last.outcome === next.outcome &&
      last.exceptionCode === next.exceptionCode;
    if (joins) found[found.length - 1] = { ...last, last: next.last };
    else found.push(next);
    return;
  }
  const place = found.findIndex((one) => isSame(one, next));
  if (place < 0) found.push(next);
  else found[place] = next;
}

function isSame(one: ScanFinding, other: ScanFinding): boolean {
  if (one.what === 'function' && other.what === 'function') return one.functionCode === other.functionCode;
  return (
    one.what === 'unit' && other.what === 'unit' && one.unit === other.unit && isSameLine(one.settings, other.settings)
  );
}

/** How many units, functions or addresses were found; a unit that answers at several speeds is one. */
export function countFindings(found: readonly ScanFinding[]): number {
  const units = new Set(found.flatMap((one) => (one.what === 'unit' ? [one.unit] : [])));
  return found.reduce((sum, one) => {
    if (!isFound(one) || one.what === 'unit') return sum;
    return sum + (one.what === 'addresses' ? one.last - one.first + 1 : 1);
  }, units.size);
}

/** Whether something was found. A broken reply to a function proves nothing. */
export function isFound(found: ScanFinding): boolean {
  switch (found.what) {
    case 'not-opened':
      return false;
    case 'unit':
      return true;
    case 'function':
      return supports(found) === 'yes';
    case 'addresses':
      return found.outcome === 'reply';
  }
}

const ILLEGAL_FUNCTION = 0x01;

/** What an answer says of the function that was asked for: exception 01 alone means that there is none (AP 7). */
export function supports({ outcome, exceptionCode }: ScanAnswer): 'yes' | 'no' | 'unsure' | 'silent' {
  if (outcome === 'silent') return 'silent';
  if (outcome === 'broken') return 'unsure';
  return exceptionCode === ILLEGAL_FUNCTION ? 'no' : 'yes';
}
