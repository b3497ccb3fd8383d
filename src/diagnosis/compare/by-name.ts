import { type FieldKind, type Span, sameBytes } from '../../modbus/index.ts';
import type { Difference } from './comparison.ts';
import { likelyCause, numberOf } from './likely.ts';
import { functionOf } from './read-theirs.ts';
import { binaryOf, type Side } from './side.ts';

/** Spans that only one transport has, and spans that are not fields. */
const SKIPPED: ReadonlySet<FieldKind> = new Set(['envelope', 'checksum', 'rest']);

/**
 * The fields that both frames have and that differ. Frames of two transports, and a request and a reply, have
 * different layouts, so their bytes cannot be compared one by one.
 */
export function differencesByName(own: Side, other: Side): Difference[] {
  const left = new Map<string, Span[]>();
  for (const span of other.spans) left.set(span.name, [...(left.get(span.name) ?? []), span]);
  const found: Difference[] = [];
  for (const span of own.spans) {
    const { name, kind } = span;
    const theirs = left.get(name)?.shift();
    if (theirs === undefined || SKIPPED.has(kind)) continue;
    // The exception bit says that theirs is an exception, not that the function differs.
    if (kind === 'function' && functionOf(own) === functionOf(other)) continue;
    const a = binaryOf(own, span.from, span.to);
    const b = binaryOf(other, theirs.from, theirs.to);
    if (a === undefined || b === undefined || sameBytes(a, b)) continue;
    found.push({
      mine: { name, kind, from: span.from, to: span.to, value: numberOf(kind, a) },
      theirs: { name, kind: theirs.kind, from: theirs.from, to: theirs.to, value: numberOf(theirs.kind, b) },
      cause: likelyCause({
        name,
        kind,
        mine: { side: own, from: span.from, to: span.to, binary: a },
        theirs: { side: other, from: theirs.from, to: theirs.to, binary: b },
        sameBefore: false,
      }),
    });
  }
  return found;
}
