import type { Direction, Field, FunctionCode, Layout, Section } from '../../modbus/index.ts';

/** A field with its limits, and where it stands. */
export interface LimitedField {
  readonly direction: Direction;
  readonly field: Field;
  readonly section: Section;
  /** Whether it is typed on its own: the encoder does not derive it, and it is in no group. */
  readonly typed: boolean;
}

/** The fields of a function that hold less than fits into them. A reply that repeats its request is not listed again. */
export function limitedFields(description: FunctionCode): LimitedField[] {
  const { request, response, section } = description;
  const of = (direction: Direction) => [...limited(description[direction], section, direction)];
  return request === response ? of('request') : [...of('request'), ...of('response')];
}

/** Those of a layout, of its groups, and of the layouts that follow by a choice. */
function* limited(layout: Layout, outer: Section, direction: Direction): Generator<LimitedField> {
  const section = layout.section ?? outer;
  for (const field of layout.fields) {
    if (field.range) yield { direction, field, section, typed: field.derive === undefined };
    for (const inner of field.group ?? []) if (inner.range) yield { direction, field: inner, section, typed: false };
  }
  for (const following of Object.values(layout.then?.cases ?? {})) yield* limited(following, section, direction);
}

/** The layout that follows where a value was chosen. Throws a `RangeError` if the layout has no choice. */
export function layoutAfter({ then }: Layout, value: number): Layout {
  const chosen = then?.cases[value] ?? then?.otherwise;
  if (chosen === undefined) throw new RangeError('a layout without a choice');
  return chosen;
}

/** How the size of a field is written: its bytes, or how they follow from the number of its items. */
export type FieldSize = number | 'n' | '2×n' | 'n/8';

/** Bytes of a list that holds more or less than one item a byte. */
const ofList = (kind: Field['kind']): FieldSize => (kind === 'registers' ? '2×n' : kind === 'bits' ? 'n/8' : 'n');

/** The size of a field: its width, or the bytes it takes whatever was read before it, or its items. */
export function fieldSize(field: Field): FieldSize {
  if (field.width > 0) return field.width;
  const fixed = field.open ? Number.NaN : field.size(new Uint8Array(), 0, 0, nothingSeen);
  return fixed > 0 ? fixed : ofList(field.kind);
}

/** The counts before the field are unknown: a size that depends on one is `NaN`. */
const nothingSeen: Parameters<Field['size']>[3] = {
  fields: {},
  count: Number.NaN,
  items: Number.NaN,
  request: undefined,
  forced: {},
  force: () => undefined,
  report: () => undefined,
};
