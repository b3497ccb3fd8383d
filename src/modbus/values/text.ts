import { LAST_ADDRESS } from '../address.ts';
import { demandWhole } from '../demand.ts';
import { type TextTypeName, textTypes } from './form-types.ts';
import type { Order } from './order.ts';
import { fromRegisters, orders, toRegisters } from './order.ts';

/** The padding of the registers after the end of a text. */
export type Padding = 'nul' | 'blank';

const PAD: Readonly<Record<Padding, number>> = { nul: 0x00, blank: 0x20 };

/** A text keeps its registers in their order; only the bytes inside each may be swapped. */
const bytesAlone = (order: Order): Order => (orders[order].lowByteFirst ? 'BADC' : 'ABCD');

type Encoding = (typeof textTypes)[TextTypeName];

export type TextReading =
  | { readonly kind: 'value'; readonly value: string }
  /** A byte that no character of the encoding has here. */
  | { readonly kind: 'not-text'; readonly byte: number; readonly at: number };

/** The text that registers hold: it ends at its first NUL, and blanks behind it may be padding. */
export function readText(
  registers: readonly number[],
  type: TextTypeName,
  order: Order,
  padding: Padding = 'nul',
): TextReading {
  const bytes = fromRegisters(registers, bytesAlone(order));
  const characters = textTypes[type] === 'wide' ? bytes.filter((_, at) => at % 2 === 1) : bytes;
  const nul = characters.indexOf(0);
  let end = nul < 0 ? characters.length : nul;
  if (padding === 'blank') while (end > 0 && characters[end - 1] === PAD.blank) end--;
  const text = characters.subarray(0, end);
  if (textTypes[type] !== 'utf-8') return { kind: 'value', value: String.fromCharCode(...text) };
  return readUtf8(text);
}

/** UTF-8 by RFC 3629: no longer form than needed, no surrogates. */
function readUtf8(bytes: Uint8Array): TextReading {
  let value = '';
  for (let at = 0; at < bytes.length; ) {
    const byte = bytes[at] as number;
    const more =
      byte < 0x80
        ? 0
        : byte >= 0xc2 && byte < 0xe0
          ? 1
          : byte >= 0xe0 && byte < 0xf0
            ? 2
            : byte >= 0xf0 && byte < 0xf5
              ? 3
              : -1;
    const rest = bytes.subarray(at + 1, at + 1 + more);
    let code = more <= 0 ? byte : byte & (0x3f >> more);
    for (const one of rest) code = (code << 6) | (one & 0x3f);
    const isWhole = more >= 0 && rest.length === more && rest.every((one) => one >> 6 === 2);
    const isShortest = more < 2 || code >= (more === 2 ? 0x800 : 0x1_0000);
    if (!isWhole || !isShortest || (code >= 0xd800 && code < 0xe000) || code > 0x10_ffff)
      return { kind: 'not-text', byte, at };
    value += String.fromCodePoint(code);
    at += 1 + more;
  }
  return { kind: 'value', value };
}

/** The bytes of a character; `undefined` if the encoding has none for it. */
function bytesOf(character: string, encoding: Encoding): readonly number[] | undefined {
  const code = character.codePointAt(0) ?? 0;
  if (encoding !== 'utf-8') return code <= 0xff ? (encoding === 'wide' ? [0, code] : [code]) : undefined;
  if (code >= 0xd800 && code < 0xe000) return undefined;
  if (code < 0x80) return [code];
  const more = code < 0x800 ? 1 : code < 0x1_0000 ? 2 : 3;
  const first = [0xc0, 0xe0, 0xf0][more - 1] as number;
  return Array.from({ length: more + 1 }, (_, at) => {
    const bits = code >> (6 * (more - at));
    return at === 0 ? first | bits : 0x80 | (bits & 0x3f);
  });
}

export type TextWriting =
  | { readonly kind: 'registers'; readonly registers: readonly number[]; readonly stored: string; readonly exact: true }
  /** A character that the encoding has not. */
  | { readonly kind: 'no-character'; readonly character: string; readonly at: number }
  | { readonly kind: 'text-too-long'; readonly got: number; readonly most: number };

/** How long a text is, and its padding. */
export interface TextRoom {
  /** Its registers; as many as it needs if absent. */
  readonly registers?: number | undefined;
  readonly padding?: Padding | undefined;
}

/** A text as registers: as many as it needs, or its room, padded. Lengths count bytes. */
export function writeText(
  text: string,
  type: TextTypeName,
  order: Order,
  { registers: room, padding = 'nul' }: TextRoom,
): TextWriting {
  const bytes: number[] = [];
  const encoding = textTypes[type];
  for (const [at, character] of Array.from(text).entries()) {
    const of = bytesOf(character, encoding);
    if (of === undefined) return { kind: 'no-character', character, at };
    bytes.push(...of);
  }
  if (room !== undefined) demandWhole('registers of a text', room, 0, LAST_ADDRESS + 1);
  const registers = room ?? Math.ceil(bytes.length / 2);
  if (bytes.length > 2 * registers) return { kind: 'text-too-long', got: bytes.length, most: 2 * registers };
  const all = new Uint8Array(2 * registers);
  all.set(bytes);
  for (let at = bytes.length; at < all.length; at++) all[at] = encoding === 'wide' && at % 2 === 0 ? 0 : PAD[padding];
  return { kind: 'registers', registers: toRegisters(all, bytesAlone(order)), stored: text, exact: true };
}
