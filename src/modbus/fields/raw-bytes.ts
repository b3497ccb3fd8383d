import { defineField, type Field, type Rule, type Seen } from '../field.ts';
import { FrameError } from '../frame-error.ts';
import { fromHex, toHex } from '../hex.ts';

interface HexParts {
  /** The number of bytes that the field takes. If it is left out, no byte says, and the field takes all there are. */
  readonly size?: (seen: Seen) => number;
  /** How many bytes it usually takes then. */
  readonly usual?: number;
  readonly rules?: readonly Rule<string>[];
  readonly replyRules?: readonly Rule<string>[];
}

/** Raw bytes, as upper-case hexadecimal pairs. Reads pairs of either case, with or without blanks. */
export function hex<N extends string>(
  name: N,
  { size, usual = 0, rules = [], replyRules = [] }: HexParts = {},
): Field<N, string> {
  return defineField<N, string>(name, {
    kind: 'bytes',
    open: size === undefined,
    usual,
    size: size === undefined ? (_bytes, at, end) => end - at : (_bytes, _at, _end, seen) => size(seen),
    rules,
    replyRules,
    read: (bytes, from, to) => toHex(bytes, from, to),
    accept: acceptHex,
    length: (value) => value.length / 2,
    write: (out, at, value) => out.set(fromHex(value) as Uint8Array, at),
  });
}

/** The value as upper-case hexadecimal pairs without blanks; throws a `FrameError` for anything else. */
export function acceptHex(value: unknown, path: string): string {
  if (value === undefined) throw new FrameError(path, { code: 'field-missing' });
  const bytes = typeof value === 'string' ? fromHex(value) : undefined;
  if (bytes === undefined) throw new FrameError(path, { code: 'not-hex', got: value });
  return toHex(bytes);
}
