import type { Span } from '../../modbus/index.ts';
import type { Cause } from './cause.ts';
import type { Difference, Place, Run } from './comparison.ts';
import { likelyCause, numberOf } from './likely.ts';
import type { Column, Piece } from './pieces.ts';
import { fitOf, functionOf, isCut } from './read-theirs.ts';
import { binaryOf, type Side, spanNamed } from './side.ts';

/** The fields that differ between two frames of one transport and direction, by their aligned bytes. */
export function differencesOf(own: Side, other: Side, pieces: readonly Piece[]): Difference[] {
  const found: Difference[] = [];
  const { first, last } = edges(pieces, 'only-theirs');
  const ended = fitOf(other) === 0 || isCut(own.bytes, other.bytes);
  const cut = ended ? tailOf(own, pieces) : undefined;
  let sameBefore = true;
  pieces.forEach((piece, index) => {
    if (index < first || index > last) return;
    const inTail = ({ kind, mineFrom }: Column) => kind === 'only-mine' && cut !== undefined && mineFrom >= cut;
    if (piece.columns.some((column) => column.kind !== 'equal' && !inTail(column))) {
      const difference = differenceOf(own, other, piece, sameBefore);
      found.push(difference);
      sameBefore &&= difference.cause.code === 'lower-case-digits';
    }
  });
  const before = stray(other, pieces.slice(0, first), 'extra-before');
  const after = stray(other, pieces.slice(last + 1), 'extra-after');
  const end = cut === undefined ? undefined : truncated(own, cut);
  return [before, ...found, after, end].filter((difference) => difference !== undefined);
}

/** The pieces that hold both frames: outside them are only bytes of one kind that belong to no field of mine. */
function edges(pieces: readonly Piece[], kind: Run['kind']): { first: number; last: number } {
  const inside = (piece: Piece) => piece.mine !== undefined || piece.columns.some((column) => column.kind !== kind);
  return { first: Math.max(0, pieces.findIndex(inside)), last: pieces.findLastIndex(inside) };
}

function stray(other: Side, pieces: readonly Piece[], code: 'extra-before' | 'extra-after'): Difference | undefined {
  const from = pieces[0]?.columns[0]?.theirsFrom;
  const to = pieces.at(-1)?.columns.at(-1)?.theirsTo;
  if (from === undefined || to === undefined) return undefined;
  const name = code === 'extra-before' ? 'before' : 'after';
  const theirs = placeOf(other, { name, kind: 'rest' }, from, to);
  return { mine: undefined, theirs, cause: { code, bytes: to - from } };
}

/** Where the bytes begin that only mine has at its end; `undefined` if it has no such bytes. */
function tailOf(own: Side, pieces: readonly Piece[]): number | undefined {
  const columns = pieces.flatMap((piece) => piece.columns);
  const after = columns.findLastIndex(({ kind }) => kind !== 'only-mine');
  const from = columns[after + 1]?.mineFrom;
  return from !== undefined && from < own.bytes.length ? from : undefined;
}

function truncated(own: Side, from: number): Difference {
  const to = own.bytes.length;
  const span = own.spans[own.spanOf[from] as number] as Span;
  return { mine: placeOf(own, span, from, to), theirs: undefined, cause: endingCause(span, from, to) };
}

/** The cause of `[from, to)` missing at the end, from this field on. */
function endingCause({ name, kind, from: begins, to: ends }: Span, from: number, to: number): Cause {
  if (name === 'end') return { code: 'line-end-missing' };
  const checksum = kind === 'checksum' && begins === from && ends === to;
  return checksum ? { code: 'checksum-missing' } : { code: 'truncated', missing: to - from };
}

function differenceOf(own: Side, other: Side, piece: Piece, sameBefore: boolean): Difference {
  const { name, kind, columns } = piece;
  const theirsFrom = columns[0]?.theirsFrom ?? 0;
  const theirsTo = columns.at(-1)?.theirsTo ?? theirsFrom;
  const theirs = theirsTo > theirsFrom ? placeOf(other, piece, theirsFrom, theirsTo) : undefined;
  if (piece.mine === undefined) return { mine: undefined, theirs, cause: onlyTheirs(own, other, piece) };
  const { from, to } = piece.mine;
  const mine = placeOf(own, piece, from, to);
  if (theirs === undefined) return { mine, theirs, cause: onlyMine(own, other, piece) };
  const half = (side: Side, place: Place) => ({ side, from: place.from, to: place.to, binary: bytesAt(side, place) });
  const cause = likelyCause({ name, kind, mine: half(own, mine), theirs: half(other, theirs), sameBefore });
  return { mine, theirs, cause };
}

/** The bytes of a place; the characters themselves if they are not digits. */
const bytesAt = (side: Side, { from, to }: Place): Uint8Array =>
  binaryOf(side, from, to) ?? side.bytes.subarray(from, to);

function placeOf(side: Side, { name, kind }: Pick<Place, 'name' | 'kind'>, from: number, to: number): Place {
  const binary = binaryOf(side, from, to);
  return { name, kind, from, to, value: binary && numberOf(kind, binary) };
}

function onlyMine(own: Side, other: Side, { name, kind, columns }: Piece): Cause {
  if (kind === 'checksum') return { code: 'checksum-missing' };
  if (functionOf(own) !== functionOf(other) && spanNamed(other, name) === undefined) {
    return { code: 'field-of-function', functionCode: functionOf(own) ?? 0 };
  }
  return kind === 'count' ? { code: 'count-missing' } : { code: 'bytes-missing', bytes: columns.length };
}

function onlyTheirs(own: Side, other: Side, { name, columns }: Piece): Cause {
  return functionOf(own) !== functionOf(other) && spanNamed(own, name) === undefined
    ? { code: 'field-of-function', functionCode: functionOf(other) ?? 0 }
    : { code: 'bytes-inserted', bytes: columns.length };
}
