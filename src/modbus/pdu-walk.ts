import { codeFault } from './code-ranges.ts';
import { type Field, type Force, type Layout, next, outOfRange, type Seen, type Values } from './field.ts';
import { describeFunction } from './functions/index.ts';
import type { Fault } from './problem.ts';
import type { Direction } from './reading.ts';

const FUNCTION_CODE = 1;

/** What is known of all PDUs of one direction, by function code, before their bytes are looked at. */
export interface Side {
  readonly direction: Direction;
  readonly layouts: readonly Layout[];
  /** The bytes of a PDU whose fields are all of fixed width, else 0. */
  readonly widths: Uint8Array;
  /** Where the byte count stands that alone tells the length, else 0, and the bytes of a PDU whose count is 0. */
  readonly countAt: Uint8Array;
  readonly uncounted: Uint8Array;
  /** 1 if no byte after the function code says where the PDU ends. */
  readonly open: Uint8Array;
}

function sideOf(direction: Direction): Side {
  const layouts = Array.from({ length: 256 }, (_, code) => describeFunction(code, direction)[direction]);
  const counts = layouts.map(countOf);
  return {
    direction,
    layouts,
    widths: Uint8Array.from(layouts, widthOf),
    countAt: Uint8Array.from(counts, (count) => count?.at ?? 0),
    uncounted: Uint8Array.from(counts, (count) => count?.uncounted ?? 0),
    open: Uint8Array.from(layouts, ({ fields }) => (fields[0]?.open ? 1 : 0)),
  };
}

function widthOf({ fields, then }: Layout): number {
  const fixed = then === undefined && fields.every(({ width }) => width > 0);
  return fixed ? fields.reduce((sum, { width }) => sum + width, FUNCTION_CODE) : 0;
}

const NOTHING: Force = Object.freeze({});

/** Byte counts that are tried: any other follows from these. */
const TRIED = [0, 1, 2, 7, 100, 255];
/** Longer than any PDU, so that none of its fields is cut off. */
const ROOM = 1024;

/**
 * Where the byte count stands in PDUs of fixed fields, a byte count, and as many bytes as it says; `undefined` for any other
 * layout. The fields themselves are asked how long they are.
 */
function countOf(layout: Layout): { at: number; uncounted: number } | undefined {
  const { fields, then } = layout;
  const list = fields.findIndex(({ width }) => width === 0);
  const counting = fields.findIndex(({ kind, width }) => kind === 'count' && width === 1);
  if (then !== undefined || list < 0 || counting < 0 || counting > list || fields[list]?.open) return undefined;
  const at = fields.slice(0, counting).reduce((sum, { width }) => sum + width, FUNCTION_CODE);
  const bytes = new Uint8Array(ROOM);
  const ends = TRIED.map((count) => {
    bytes[at] = count;
    return new PduWalk().endOf(layout, bytes, 0, ROOM) - count;
  });
  const uncounted = ends[0] as number;
  return ends.every((end) => end === uncounted) ? { at, uncounted } : undefined;
}

/**
 * Walks over a PDU's fields as `readPdu` does, but makes no spans and keeps no lists: it says where the PDU ends, and
 * whether it breaks a rule. A search for frames at every place of a stream needs no more, and this is many times as fast.
 */
export class PduWalk implements Seen {
  /** No byte says where the PDU ends: the last field takes all the bytes there are. */
  open = false;
  /** Where an open PDU ends that is as long as they usually are, else 0. */
  usual = 0;
  /** No field breaks a rule of its own, and no field has bytes that make no whole item. */
  legal = true;
  /** Something is reserved or against the specification's advice. */
  warned = false;
  fields: Record<string, unknown> = {};
  count = 0;
  items = 0;
  readonly request = undefined;
  forced = NOTHING;

  force(name: string, value: number | string): void {
    this.forced = { ...this.forced, [name]: value };
  }

  report({ severity }: Fault): void {
    if (severity === 'error') this.legal = false;
    else if (severity === 'warning') this.warned = true;
  }

  /** Where the PDU in `bytes[from, end)` ends by its fields; beyond `end` if bytes are missing. */
  end(side: Side, bytes: Uint8Array, from: number, end: number): number {
    return this.endOf(side.layouts[bytes[from] as number] as Layout, bytes, from, end);
  }

  /** The same of a PDU of this layout. */
  endOf(first: Layout, bytes: Uint8Array, from: number, end: number): number {
    this.open = false;
    this.usual = 0;
    let layout: Layout | undefined = first;
    let at = from + FUNCTION_CODE;
    while (layout !== undefined) {
      const { fields, then } = layout;
      for (let i = 0; i < fields.length; i++) {
        const field = fields[i] as Field;
        const size = field.width || field.size(bytes, at, end, this);
        const stop = at + size;
        if (stop > end) return stop;
        if (field.open) {
          this.open = true;
          this.usual = field.usual && at + field.usual;
        } else if (field.derive !== undefined) {
          this.derived(field, number(bytes, at, size));
        } else if (then !== undefined && field.name === then.by) {
          this.fields[field.name] = number(bytes, at, size);
        }
        at = stop;
      }
      layout = next(layout, this.fields);
    }
    return at;
  }

  /** Judges the PDU in `bytes[from, end)`, whose fields are known to end at `end`. */
  judge(side: Side, bytes: Uint8Array, from: number, end: number): void {
    this.open = false;
    this.legal = true;
    this.warned = false;
    this.fields = {};
    this.forced = NOTHING;
    const functionCode = bytes[from] as number;
    const fault = codeFault(side.direction === 'response' ? functionCode & 0x7f : functionCode);
    if (fault !== undefined) this.report(fault);
    let layout: Layout | undefined = side.layouts[functionCode];
    let at = from + FUNCTION_CODE;
    while (layout !== undefined) {
      const { fields } = layout;
      for (let i = 0; i < fields.length; i++) {
        const field = fields[i] as Field;
        const size = field.width || field.size(bytes, at, end, this);
        this.field(field, bytes, at, size);
        if (field.open) this.open = true;
        at += size;
      }
      layout = next(layout, this.fields);
    }
  }

  private field(field: Field, bytes: Uint8Array, at: number, size: number): void {
    const { rules, group } = field;
    if (group !== undefined) {
      this.groups(field, group, bytes, at, at + size);
      return;
    }
    if (field.width === 0) {
      const whole = field.whole(bytes, at, at + size);
      if (whole !== size) this.legal = false;
      // A list without rules has nothing to be judged.
      if (rules.length === 0) return;
    }
    const value = field.plain ? number(bytes, at, size) : field.read(bytes, at, at + size, this);
    if (field.derive === undefined) this.fields[field.name] = value;
    else this.derived(field, value as number);
    if (field.range !== undefined) {
      const fault = outOfRange(field, value);
      if (fault !== undefined) this.report(fault);
    }
    this.apply(rules, value);
  }

  /** Judges each group. A rule of the whole list sees of a group what this keeps: not its own lists. */
  private groups({ rules }: Field, group: readonly Field[], bytes: Uint8Array, from: number, end: number): void {
    const list: Values[] = [];
    let at = from;
    while (at < end) {
      this.fields = {};
      for (let i = 0; i < group.length; i++) {
        const field = group[i] as Field;
        const size = field.width || field.size(bytes, at, end, this);
        if (size < 0 || size > end - at) {
          this.legal = false;
          return;
        }
        this.field(field, bytes, at, size);
        at += size;
      }
      list.push(this.fields);
    }
    this.apply(rules, list);
  }

  private apply(rules: Field['rules'], value: unknown): void {
    for (let i = 0; i < rules.length; i++) {
      const fault = (rules[i] as Field['rules'][number])(value, this);
      if (fault !== undefined) this.report(fault);
    }
  }

  private derived({ kind }: Field, value: number): void {
    if (kind === 'count') this.count = value;
    else this.items = value;
  }
}

const number = (bytes: Uint8Array, at: number, width: number): number =>
  width === 1 ? (bytes[at] as number) : ((bytes[at] as number) << 8) | (bytes[at + 1] as number);

export const REQUEST = sideOf('request');
export const RESPONSE = sideOf('response');

/** Whether what is judged of a field is the same: a reply's rules against its request are no part of that. */
const alike = (a: Field | undefined, b: Field | undefined): boolean =>
  a === b ||
  (a !== undefined &&
    b !== undefined &&
    a.kind === b.kind &&
    a.width === b.width &&
    a.open === b.open &&
    a.group === b.group &&
    a.range?.least === b.range?.least &&
    a.range?.most === b.range?.most &&
    a.rules.length === b.rules.length &&
    a.rules.every((rule, index) => rule === b.rules[index]));

/** By function code, 1 if requests and replies have the same fields under the same rules, so that both are judged alike. */
export const JUDGED_ALIKE: Uint8Array = Uint8Array.from(REQUEST.layouts, (asked, code) => {
  const answered = RESPONSE.layouts[code] as Layout;
  const same = asked.fields.length === answered.fields.length && asked.then === answered.then;
  return same && asked.fields.every((field, index) => alike(field, answered.fields[index])) ? 1 : 0;
});
