import { crc16 } from '../../modbus/index.ts';
import type { Token } from './items.ts';
import type { Output } from './output.ts';
import type { Source } from './source.ts';
import type { SetAside, TextProblem } from './types.ts';

/** Fewest bytes that have a checksum. */
const LEAST = 2;
/** What is written before the checksum that is expected. */
const EXPECTED = /(?:crc|lrc|checksum|should be|must be|expected|correct)[^\n]{0,24}$/i;
const BEFORE = 60;
const COMMENT = /(?:\/\/|\/\*|\(\*|\s#\s|\s--\s)[^\n]*$/;

/** A problem for each row of numbers that might be bytes and was not read, and for each checksum that the text says. */
export function problemsAside(source: Source, output: Output): readonly TextProblem[] {
  const { plain, numbers, addresses } = source;
  const problems: TextProblem[] = addresses.map(({ start, end }) => ({
    code: 'set-aside',
    start,
    end,
    why: 'address',
  }));
  const { bytes, origin, problems: known } = output;
  const named = new Set(known.map(({ start }) => start));
  let row: { readonly start: number; end: number; readonly why: SetAside } | undefined;
  let next = 0;
  const flush = () => {
    if (row !== undefined) problems.push({ code: 'set-aside', ...row });
    row = undefined;
  };
  for (const token of numbers) {
    const { start, end } = token;
    while (next < origin.length && (origin[next]?.end ?? 0) <= start) next++;
    // Those of a comment come after those behind it.
    while (next > 0 && (origin[next - 1]?.end ?? 0) > start) next--;
    if ((origin[next]?.start ?? end) < end || named.has(start)) continue;
    const got = saidChecksum(plain, token);
    const before = got === undefined ? undefined : bytesBefore(output, bytes, next);
    if (got !== undefined && before !== undefined) {
      flush();
      problems.push({ code: 'checksum-said', start, end, got, expected: crc16(before) });
    } else if (mayBeByte(plain, token) && !counts(plain, token, output, next)) {
      const why = source.repeated.has(token) ? 'repeated' : isInComment(plain, start) ? 'comment' : 'words';
      if (row?.why === why && /^[^\n\w]*$/.test(plain.slice(row.end, start))) row.end = end;
      else {
        flush();
        row = { start, end, why };
      }
    }
  }
  flush();
  return problems;
}

function isInComment(plain: string, at: number): boolean {
  const from = Math.max(at - BEFORE, plain.lastIndexOf('\n', at) + 1);
  return COMMENT.test(plain.slice(from, at));
}

/** Whether a number could be a byte: two hexadecimal digits, or up to 255; not a name with a colon behind it. */
function mayBeByte(plain: string, { from, to, end, isCount }: Token): boolean {
  if (isCount || to - from > 3 || plain[end] === ':') return false;
  const digits = plain.slice(from, to);
  return digits.length === 2 || (/^\d+$/.test(digits) && Number(digits) <= 0xff);
}

/** Whether a number in parentheses is how many bytes stand before or behind it: `01 03 02 (3)`. */
function counts(plain: string, { start, end }: Token, { chunks, origin }: Output, next: number): boolean {
  if (plain[start - 1] !== '(' || plain[end] !== ')') return false;
  const size = Number(plain.slice(start, end));
  if (size <= next && chunkSize(chunks, next - 1) === size) return true;
  return next < origin.length && chunkSize(chunks, next) === size;
}

function chunkSize(chunks: Output['chunks'], place: number): number | undefined {
  const chunk = chunkAt(chunks, place);
  return chunk && chunk.to - chunk.from;
}

/** The chunk that has a byte. */
function chunkAt(chunks: Output['chunks'], place: number): Output['chunks'][number] | undefined {
  let [low, high] = [0, chunks.length - 1];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((chunks[middle]?.to ?? 0) <= place) low = middle + 1;
    else high = middle;
  }
  const chunk = chunks[low];
  return chunk !== undefined && chunk.from <= place && place < chunk.to ? chunk : undefined;
}

/** The number of four digits that the text says is the checksum. */
function saidChecksum(plain: string, { from, to, start }: Token): number | undefined {
  if (to - from !== 4) return undefined;
  const isSaid = EXPECTED.test(plain.slice(Math.max(0, start - BEFORE), start));
  return isSaid ? Number.parseInt(plain.slice(from, to), 16) : undefined;
}

/** The bytes of the chunk that ends before the byte at `next`. */
function bytesBefore({ chunks }: Output, bytes: Uint8Array, next: number): Uint8Array | undefined {
  const chunk = chunkAt(chunks, next - 1);
  return chunk !== undefined && chunk.to - chunk.from >= LEAST ? bytes.subarray(chunk.from, chunk.to) : undefined;
}
