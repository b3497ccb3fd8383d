import { LAST_ADDRESS } from '../address.ts';
import { demandWhole } from '../demand.ts';
import type { Order } from './order.ts';
import { fromRegisters, orders, toRegisters } from './order.ts';

/** The padding of the registers after the end of a text. */
export type Padding = 'nul' | 'blank';

const PAD: Readonly<Record<Padding, number>> = { nul: 0x00, blank: 0x20 };

/** A text keeps its registers in their order; only the bytes inside each may be swapped. */
const bytesAlone = (order: Order): Order => (orders[order].lowByteFirst ? 'BADC' : 'ABCD');

export type TextReading =
  | { readonly kind: 'value'; readonly value: string }
  | { readonly kind: 'not-ascii'; readonly byte: number; readonly at: number };

/** The ASCII text that registers hold, without the padding at its end. */
export function readText(registers: readonly number[], order: Order, padding: Padding = 'nul'): TextReading {
  const bytes = fromRegisters(registers, bytesAlone(order));
  let end = bytes.length;
  while (end > 0 && bytes[end - 1] === PAD[padding]) end--;
  const text = bytes.subarray(0, end);
  const at = text.findIndex((byte) => byte > 0x7f);
  if (at >= 0) return { kind: 'not-ascii', byte: text[at] as number, at };
  return { kind: 'value', value: Array.from(text, (byte) => String.fromCharCode(byte)).join('') };
}

export type TextWriting =
  | { readonly kind: 'registers'; readonly registers: readonly number[]; readonly stored: string; readonly exact: true }
  | { readonly kind: 'not-ascii'; readonly character: string; readonly at: number }
  | { readonly kind: 'text-too-long'; readonly got: number; readonly most: number };

/** A text as registers: as many as it needs, or `room` of them, padded. Lengths count characters. */
export function writeText(text: string, order: Order, room?: number, padding: Padding = 'nul'): TextWriting {
  const characters = Array.from(text);
  const at = characters.findIndex((character) => character > '\x7f');
  if (at >= 0) return { kind: 'not-ascii', character: characters[at] as string, at };
  const registers = room ?? Math.ceil(text.length / 2);
  if (room !== undefined) demandWhole('registers of a text', room, 0, LAST_ADDRESS + 1);
  if (text.length > 2 * registers) return { kind: 'text-too-long', got: text.length, most: 2 * registers };
  const bytes = new Uint8Array(2 * registers).fill(PAD[padding]);
  for (let index = 0; index < text.length; index++) bytes[index] = text.charCodeAt(index);
  return { kind: 'registers', registers: toRegisters(bytes, bytesAlone(order)), stored: text, exact: true };
}
