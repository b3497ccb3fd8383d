import type { Program } from '../../codegen/index.ts';
import type { Reading } from '../../modbus/index.ts';

/** Bytes of the frame, `to` not included. */
export interface ByteRange {
  readonly from: number;
  readonly to: number;
}

/**
 * The bytes of the frame that a line of a program makes or reads, by the line's number from 1. A line that has to do with
 * several fields has the bytes from the first to the last of them; one whose fields the frame does not have is left out.
 */
export function bytesByLine(program: Program, file: number, { spans }: Reading): ReadonlyMap<number, ByteRange> {
  const known = new Map<string, ByteRange>(spans.map((span) => [span.name, span]));
  return new Map(
    program.lines.flatMap(({ file: of, line, spans: names }) => {
      const found = of === file ? names.flatMap((name) => known.get(name) ?? []) : [];
      if (found.length === 0) return [];
      const from = Math.min(...found.map((range) => range.from));
      const to = Math.max(...found.map((range) => range.to));
      return [[line, { from, to }] as const];
    }),
  );
}
