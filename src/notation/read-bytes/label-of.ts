import { clausesOf } from './clauses.ts';
import { scanLine } from './scan-line.ts';
import type { ChunkLabel } from './types.ts';

/** The most characters of a line that are looked through for what they say of the bytes behind them. */
const MOST = 400;

/** What the beginning of a line says of the bytes that follow it. */
export function labelOf(before: string): ChunkLabel {
  if (before.trim() === '') return {};
  // Some words say a side only right before bytes.
  const text = `${before.slice(-MOST)} b'`;
  return clausesOf(text, scanLine(text, 0)).at(-1)?.label ?? {};
}
