import { fromHex } from '../../modbus/index.ts';
import { readNumber, readOctets } from '../../notation/index.ts';
import { valueBytes } from './algorithm-rows.ts';

/** Bytes that a checksum in the catalogue has. */
const SIZES = [1, 2, 4];

/**
 * The bytes that a claimed value may be, in one order: those of hexadecimal digits as typed (`1AF3`, `F3 1A`), or of a
 * number (`0x1AF3`, `6899`). Digits alone may be both. Empty for what is neither, or has a size that no checksum has.
 */
export function readClaim(text: string): readonly Uint8Array[] {
  const claims: Uint8Array[] = [];
  const octets = readOctets(text);
  const pairs = octets === undefined ? undefined : fromHex(octets);
  if (pairs) claims.push(pairs);
  const number = readNumber(text.trim());
  if (number !== undefined && Number.isInteger(number) && number >= 0 && number < 2 ** 32) {
    const width = number > 0xffff ? 32 : number > 0xff ? 16 : 8;
    const bytes = valueBytes(number, width);
    if (!claims.some((claim) => String(claim) === String(bytes))) claims.push(bytes);
  }
  return claims.filter(({ length }) => SIZES.includes(length));
}
