import { fromHex, toHex } from '../modbus/index.ts';

/**
 * Raw bytes as a person types them into a field: hexadecimal pairs, with or without blanks, `0x` and commas, and text in
 * double quotes for its ASCII bytes: `01 FF "PLC"`. Answers the pairs as one upper-case run; `undefined` for anything else.
 */
export function readOctets(text: string): string | undefined {
  let pairs = '';
  for (const [piece] of text.matchAll(/"[^"]*"?|[^"]+/g)) {
    const read = piece.startsWith('"') ? readQuoted(piece) : readPairs(piece);
    if (read === undefined) return undefined;
    pairs += read;
  }
  return pairs;
}

function readQuoted(piece: string): string | undefined {
  if (!/^"[ -~]*"$/.test(piece)) return undefined;
  return toHex(Uint8Array.from(piece.slice(1, -1), (character) => character.charCodeAt(0)));
}

function readPairs(piece: string): string | undefined {
  // A single digit after 0x is a byte of its own.
  const digits = piece
    .replace(/0x([0-9a-f])(?![0-9a-f])/gi, ' 0$1')
    .replace(/0x/gi, ' ')
    .replace(/[\s,;]+/g, '');
  return fromHex(digits) === undefined ? undefined : digits.toUpperCase();
}
