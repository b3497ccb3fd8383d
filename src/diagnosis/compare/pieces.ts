import type { FieldKind, Span } from '../../modbus/index.ts';
import type { Column as Aligned } from './align.ts';
import type { Run } from './comparison.ts';
import type { Side } from './side.ts';

/** One column with the places of both sides; the place is empty on a side that lacks the byte. */
export type Column = Pick<Run, 'kind' | 'mineFrom' | 'mineTo' | 'theirsFrom' | 'theirsTo'>;

/** The columns of one field of mine, or of a field that only theirs has. */
export interface Piece {
  readonly name: string;
  readonly kind: FieldKind;
  /** The field of mine, if it has one. */
  readonly mine: Span | undefined;
  readonly columns: Column[];
}

/** Groups aligned columns by field. Bytes that only theirs has go to the field of mine that they are in or continue. */
export function piecesOf(own: Side, other: Side, columns: readonly Aligned[]): Piece[] {
  const pieces: Piece[] = [];
  const following = nextSpans(own, columns);
  let mineAt = 0;
  let theirsAt = 0;
  columns.forEach(({ mine, theirs }, index) => {
    const span = mine >= 0 ? spanAt(own, mine) : adopted(pieces.at(-1), following[index], spanAt(other, theirs));
    const { name, kind } = span ?? (spanAt(other, theirs) as Span);
    const mineTo = mineAt + (mine >= 0 ? 1 : 0);
    const theirsTo = theirsAt + (theirs >= 0 ? 1 : 0);
    const last = pieces.at(-1);
    const piece = last && last.mine === span && last.name === name ? last : { name, kind, mine: span, columns: [] };
    if (piece !== last) pieces.push(piece);
    piece.columns.push({
      kind: kindOf(mine, theirs, own.bytes[mine] === other.bytes[theirs]),
      mineFrom: mineAt,
      mineTo,
      theirsFrom: theirsAt,
      theirsTo,
    });
    mineAt = mineTo;
    theirsAt = theirsTo;
  });
  return pieces;
}

const spanAt = ({ spans, spanOf }: Side, at: number): Span | undefined => spans[spanOf[at] ?? -1];

/** The field of mine that a byte of theirs alone belongs to, so that no field is split into two pieces. */
function adopted(last: Piece | undefined, next: Span | undefined, span: Span | undefined): Span | undefined {
  const before = last?.mine;
  if (before !== undefined && (before === next || before.name === span?.name)) return before;
  return next !== undefined && next.name === span?.name ? next : undefined;
}

/** For each column, the field of the first byte of mine at or after it. */
function nextSpans(own: Side, columns: readonly Aligned[]): (Span | undefined)[] {
  const following: (Span | undefined)[] = new Array(columns.length);
  let next: Span | undefined;
  for (let index = columns.length - 1; index >= 0; index--) {
    const at = (columns[index] as Aligned).mine;
    if (at >= 0) next = spanAt(own, at);
    following[index] = next;
  }
  return following;
}

function kindOf(mine: number, theirs: number, equal: boolean): Run['kind'] {
  if (theirs < 0) return 'only-mine';
  if (mine < 0) return 'only-theirs';
  return equal ? 'equal' : 'different';
}
