import { type DecodeContext, MOST_ASCII, sameBytes } from '../modbus/index.ts';
import { align, type Column } from './compare/align.ts';
import { differencesByName } from './compare/by-name.ts';
import type { Cause } from './compare/cause.ts';
import type { Comparison, Difference, Run } from './compare/comparison.ts';
import { differencesOf } from './compare/differences.ts';
import { type Piece, piecesOf } from './compare/pieces.ts';
import { FITS, fitOf, functionOf, isCut, PROVED, readTheirs } from './compare/read-theirs.ts';
import { checkAt, readSide, type Side } from './compare/side.ts';

/** Bytes of each frame that are compared: a few more than the longest ASCII frame has. */
export const MOST_COMPARED = MOST_ASCII + 7;

/**
 * Compares a frame with one that was sent or received: their bytes, aligned so that missing and added ones stay in one piece,
 * and each field that differs with the likely cause. `context` says how mine is read; theirs is read alike unless it is
 * plainly of the other direction or another transport, and then fields are compared by name. Bytes beyond
 * `MOST_COMPARED` are not compared, and a cause says so. Never throws.
 */
export function compareFrames(mine: Uint8Array, theirs: Uint8Array, context: DecodeContext): Comparison {
  const own = readSide(mine.subarray(0, MOST_COMPARED), context);
  const cut = theirs.subarray(0, MOST_COMPARED);
  const equal = sameBytes(mine, theirs);
  const first = equal ? own : readTheirs(own, cut, context);
  const { side: other, columns } = layOut(own, first, context);
  const pieces = piecesOf(own, other, columns);
  const runs = pieces.flatMap(runsOf);
  const { transport, direction } = other.reading;
  const alike =
    own.reading.transport === transport &&
    own.reading.direction === direction &&
    (isException(own) === isException(other) || fitOf(other) === 0);
  const read = { transport, direction, alike, runs };
  if (equal) return { ...read, differences: [], causes: [{ code: 'identical' }] };
  const differences = alike ? differencesOf(own, other, pieces) : differencesByName(own, other);
  const causes = causesOf({ own, other, pieces, differences, alike }, mine, theirs, context);
  return { ...read, differences, causes };
}

/** Aligns the frames; a frame of theirs with stray bytes around it is read again without them, unless its own bytes prove it. */
function layOut(own: Side, other: Side, context: DecodeContext): { side: Side; columns: Column[] } {
  const alignWith = (side: Side) => align(own.bytes, side.bytes, sameFields(own, side));
  const columns = alignWith(other);
  const fit = fitOf(other);
  const proved = fit === PROVED || (fit === FITS && context.transport === 'pdu');
  const begins = columns.findIndex(({ mine }) => mine >= 0);
  const ends = other.bytes.length - columns.toReversed().findIndex(({ mine }) => mine >= 0);
  if (proved || begins < 0 || (begins === 0 && ends === other.bytes.length)) return { side: other, columns };
  const side = readSide(other.bytes, context, begins, ends);
  return { side, columns: alignWith(side) };
}

/** Whether byte `i` of one frame and byte `j` of the other stand in fields of the same name. */
function sameFields(own: Side, other: Side): (i: number, j: number) => boolean {
  // The fields of a truncated frame are not where they seem: its last bytes are read as a checksum.
  if (isCut(own.bytes, other.bytes)) return () => true;
  const names = [...own.spans, ...other.spans].map(({ name }) => name);
  const ids = ({ spans, spanOf }: Side) => spanOf.map((index) => names.indexOf(spans[index]?.name ?? ''));
  const [mine, theirs] = [ids(own), ids(other)];
  return (i, j) => mine[i] === theirs[j];
}

/** The runs of a piece: columns of one kind that follow each other. */
function runsOf({ name, kind: fieldKind, columns }: Piece): Run[] {
  const runs: Run[] = [];
  for (const { kind, mineFrom, mineTo, theirsFrom, theirsTo } of columns) {
    const last = runs[runs.length - 1];
    if (last?.kind === kind) runs[runs.length - 1] = { ...last, mineTo, theirsTo };
    else runs.push({ kind, name, fieldKind, mineFrom, mineTo, theirsFrom, theirsTo });
  }
  return runs;
}

const isException = ({ reading: { direction, functionCode } }: Side) =>
  direction === 'response' && functionCode !== undefined && functionCode > 0x80;

interface Compared {
  readonly own: Side;
  readonly other: Side;
  readonly pieces: readonly Piece[];
  readonly differences: readonly Difference[];
  readonly alike: boolean;
}

function causesOf(
  { own, other, pieces, differences, alike }: Compared,
  mine: Uint8Array,
  theirs: Uint8Array,
  { request }: DecodeContext,
): Cause[] {
  const causes: Cause[] = [];
  const [a, b] = [own.reading, other.reading];
  if (request !== undefined && a.direction === 'response' && sameBytes(request, theirs)) {
    causes.push({ code: 'echo-of-request' });
  }
  if (a.transport !== b.transport) {
    causes.push({
      code: 'other-transport',
      mine: a.transport,
      theirs: b.transport,
      same: differences.length === 0 && a.direction === b.direction,
    });
  }
  if (!alike && isException(other) !== isException(own)) {
    const [whose, side] = isException(other) ? (['theirs', other] as const) : (['mine', own] as const);
    const exceptionCode = side.reading.fields['exceptionCode'];
    causes.push({
      code: 'exception-instead',
      whose,
      functionCode: functionOf(side) ?? 0,
      exceptionCode: typeof exceptionCode === 'number' ? exceptionCode : undefined,
    });
  } else if (a.direction !== b.direction && causes.length === 0) {
    causes.push({ code: 'other-direction', theirs: b.direction });
  }
  if (alike && hasChecksumOf(own, other, pieces)) causes.push({ code: 'changed-after-checksum' });
  if (mine.length > MOST_COMPARED || theirs.length > MOST_COMPARED) {
    causes.push({
      code: 'left-out',
      mine: Math.max(0, mine.length - MOST_COMPARED),
      theirs: Math.max(0, theirs.length - MOST_COMPARED),
    });
  }
  return causes;
}

/** Whether theirs carries the checksum that is right for mine, and wrong for its own bytes. */
function hasChecksumOf(own: Side, other: Side, pieces: readonly Piece[]): boolean {
  const columns = pieces.find(({ kind, mine }) => kind === 'checksum' && mine !== undefined)?.columns ?? [];
  const [first, last] = [columns[0], columns.at(-1)];
  if (first === undefined || last === undefined || columns.some(({ kind }) => kind !== 'equal')) return false;
  const mine = checkAt(own, first.mineFrom, last.mineTo);
  const theirs = checkAt(other, first.theirsFrom, last.theirsTo);
  return mine?.got === mine?.expected && theirs?.got !== theirs?.expected;
}
