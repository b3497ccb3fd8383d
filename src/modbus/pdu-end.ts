import { type Force, type Layout, next, type Seen } from './field.ts';
import { describeFunction } from './functions/index.ts';
import type { Direction } from './reading.ts';

const layoutsOf = (direction: Direction): readonly Layout[] =>
  Array.from({ length: 256 }, (_, code) => describeFunction(code, direction)[direction]);

const LAYOUTS: Readonly<Record<Direction, readonly Layout[]>> = {
  request: layoutsOf('request'),
  response: layoutsOf('response'),
};

/**
 * The third walker over a function's fields: it only adds up their sizes. It says where a PDU ends without making values,
 * spans or problems, which is what looking for frames at every place of a stream needs.
 */
export class PduEnd implements Seen {
  /** No byte tells where the PDU ends: the last field takes all there is. */
  open = false;
  /** Where an open PDU ends that is as long as they usually are, else 0. */
  usual = 0;
  readonly fields: Record<string, unknown> = {};
  count = 0;
  items = 0;
  readonly request = undefined;
  readonly forced: Force = {};
  force(): void {}
  report(): void {}

  /** Where the PDU in `bytes[from, end)` ends by its fields; beyond `end` where bytes are missing. */
  of(direction: Direction, bytes: Uint8Array, from: number, end: number): number {
    this.open = false;
    this.usual = 0;
    let layout: Layout | undefined = LAYOUTS[direction][bytes[from] as number];
    let at = from + 1;
    while (layout !== undefined) {
      const { fields, then } = layout;
      for (const field of fields) {
        const size = field.width || field.size(bytes, at, end, this);
        const stop = at + size;
        if (stop > end) return stop;
        if (field.open) {
          this.open = true;
          this.usual = field.usual && at + field.usual;
        } else if (field.derive !== undefined) {
          if (field.kind === 'count') this.count = number(bytes, at, size);
          else this.items = number(bytes, at, size);
        } else if (then !== undefined && field.name === then.by) {
          this.fields[field.name] = number(bytes, at, size);
        }
        at = stop;
      }
      layout = next(layout, this.fields);
    }
    return at;
  }
}

/** Whether no byte of a frame with this function code tells where it ends, in either direction. */
export const ALWAYS_OPEN: readonly boolean[] = Array.from({ length: 256 }, (_, code) =>
  [LAYOUTS.request, LAYOUTS.response].every((layouts) => layouts[code]?.fields[0]?.open),
);

const number = (bytes: Uint8Array, at: number, width: number): number =>
  width === 1 ? (bytes[at] as number) : ((bytes[at] as number) << 8) | (bytes[at + 1] as number);
