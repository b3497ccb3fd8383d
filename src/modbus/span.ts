/** What kind of value a field holds: it decides the control in a form, the colour of the bytes, and the wording. */
export type FieldKind =
  | 'envelope'
  | 'unit'
  | 'function'
  | 'address'
  | 'quantity'
  | 'count'
  | 'number'
  | 'choice'
  | 'flag'
  | 'registers'
  | 'bits'
  | 'bytes'
  | 'list'
  | 'groups'
  | 'checksum'
  | 'rest';

/** Kinds of fields whose bytes make numbers of two, the high byte first; of the CRC it is the low one (SL 2.5.1.2). */
export const inPairs: ReadonlySet<FieldKind> = new Set([
  'address',
  'quantity',
  'number',
  'choice',
  'flag',
  'envelope',
  'count',
  'registers',
  'checksum',
]);

/** The bytes `[from, to)` of a frame and the field they belong to. */
export class Span {
  readonly name: string;
  readonly kind: FieldKind;
  readonly from: number;
  readonly to: number;

  constructor(name: string, kind: FieldKind, from: number, to: number) {
    this.name = name;
    this.kind = kind;
    this.from = from;
    this.to = to;
  }
}
