import { exceptionCodes, type SerialLine } from '../../modbus/index.ts';
import { readNumber } from '../../notation/index.ts';
import { type AskedChecksum, checksumAsked } from './asked-checksum.ts';
import { type AskedTiming, timingAsked } from './asked-timing.ts';

/** What a text asks that no frame answers, but another view of the page does. */
export type InputTool =
  | AskedChecksum
  | AskedTiming
  /** What the code of an exception means (AP 7). */
  | { readonly tool: 'exception'; readonly code: number };

/** A longer text, in characters, asks for nothing of the kind. */
const LONGEST = 2000;

/** Reads what names a subject of another view, with its values: `crc 02 07`, `t3.5 9600 8N1`, `exception 02`. */
export function toolAsked(text: string, line: SerialLine): InputTool | undefined {
  const typed = text.trim().replace(/\s*\?$/, '');
  if (typed.length > LONGEST || typed.includes('\n')) return undefined;
  return exceptionAsked(typed) ?? timingAsked(typed, line) ?? checksumAsked(typed);
}

const EXCEPTION =
  /^(?:what\s+(?:is|does|means?)\s+)?(?:an?\s+|the\s+)?(?:modbus\s+)?(?:exception|error)(?:\s+code)?\s*[:#=]?\s*(0x[\da-f]{1,2}|\d{1,3}|[\da-f]{2}h?)(?:\s+means?)?$/i;

function exceptionAsked(typed: string): InputTool | undefined {
  const [, digits] = EXCEPTION.exec(typed) ?? [];
  if (digits === undefined) return undefined;
  const isKnown = (code: number | undefined) => exceptionCodes.some((one) => one.code === code);
  const [decimal, hex] = [readNumber(digits), Number.parseInt(digits, 16)];
  const code = isKnown(decimal) || !isKnown(hex) ? (decimal ?? hex) : hex;
  return code >= 1 && code <= 0xff ? { tool: 'exception', code } : undefined;
}
