import { crc16 } from '../../modbus/index.ts';
import type { Token } from './items.ts';
import type { Output } from './output.ts';
import type { Aside, Source } from './source.ts';
import type { TextProblem } from './types.ts';

/** Fewest bytes that have a checksum. */
const LEAST = 2;
/** What is written before the checksum that is expected. */
const EXPECTED = /(?:crc|lrc|checksum|should be|must be|expected|correct)[^\n]{0,24}$/i;
const BEFORE = 60;

/** A problem for each row of numbers that might be bytes and was set aside, and for each checksum that the text says. */
export function problemsAside({ plain, aside }: Source, output: Output): readonly TextProblem[] {
  const { bytes } = output;
  return aside.flatMap((one): readonly TextProblem[] => {
    const { start, end, tokens, why } = one;
    const got = saidChecksum(plain, one);
    const before = got === undefined ? undefined : bytesBefore(output, bytes, start);
    if (got !== undefined && before !== undefined)
      return [{ code: 'checksum-said', start, end, got, expected: crc16(before) }];
    if (isRead(output, start, end)) return [];
    if (tokens.length > 0 && !tokens.some((token) => mayBeByte(plain, token))) return [];
    return [{ code: 'set-aside', start, end, why }];
  });
}

/** Whether a byte was read from a place, in another notation. */
function isRead({ origin }: Output, start: number, end: number): boolean {
  let [low, high] = [0, origin.length];
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((origin[middle]?.end ?? 0) <= start) low = middle + 1;
    else high = middle;
  }
  return (origin[low]?.start ?? end) < end;
}

/** Whether a number could be a byte: two hexadecimal digits, or up to 255. */
function mayBeByte(plain: string, { kind, from, to }: Token): boolean {
  if (kind !== 'number' || to - from > 3) return false;
  const digits = plain.slice(from, to);
  return digits.length === 2 || (/^\d+$/.test(digits) && Number(digits) <= 0xff);
}

/** The number of four digits that a row is, if the text before it says that it is the checksum. */
function saidChecksum(plain: string, { tokens }: Aside): number | undefined {
  const [token] = tokens;
  if (tokens.length !== 1 || token === undefined || token.to - token.from !== 4) return undefined;
  const isSaid = EXPECTED.test(plain.slice(Math.max(0, token.start - BEFORE), token.start));
  return isSaid ? Number.parseInt(plain.slice(token.from, token.to), 16) : undefined;
}

/** The bytes of the last chunk before a place. */
function bytesBefore({ chunks, origin }: Output, bytes: Uint8Array, place: number): Uint8Array | undefined {
  const chunk = chunks.findLast(({ to }) => (origin[to - 1]?.end ?? 0) <= place);
  return chunk !== undefined && chunk.to - chunk.from >= LEAST ? bytes.subarray(chunk.from, chunk.to) : undefined;
}
