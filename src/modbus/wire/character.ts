import { demandFormat, type SerialFormat } from '../timing/index.ts';

/** 1 is what an idle line has (mark, OFF), 0 is a start bit (space, ON; SL 3.3.2). */
export type Level = 0 | 1;

export type BitKind = 'start' | 'data' | 'parity' | 'stop';

/** One bit as the line carries it. */
export interface WireBit {
  readonly kind: BitKind;
  readonly level: Level;
}

/** The bit that makes the number of ones even or odd (SL 2.5.1). Throws a `RangeError` for a format that does not exist. */
export function parityBit(value: number, format: SerialFormat): Level {
  demandFormat(format);
  const { dataBits, parity } = format;
  let odd = parity === 'odd' ? 1 : 0;
  for (let bit = 0; bit < dataBits; bit++) odd ^= (value >> bit) & 1;
  return odd as Level;
}

/**
 * The bits of a character in the order in which they are sent: start, data with the least significant bit first, parity,
 * stop (SL 2.5.1). Bits that the format has no room for are not sent. Throws a `RangeError` for a format that there is not.
 */
export function characterBits(value: number, format: SerialFormat): WireBit[] {
  demandFormat(format);
  const bits: WireBit[] = [{ kind: 'start', level: 0 }];
  for (let bit = 0; bit < format.dataBits; bit++) bits.push({ kind: 'data', level: ((value >> bit) & 1) as Level });
  if (format.parity !== 'none') bits.push({ kind: 'parity', level: parityBit(value, format) });
  for (let stop = 0; stop < format.stopBits; stop++) bits.push({ kind: 'stop', level: 1 });
  return bits;
}
