import { toHex } from '../modbus/index.ts';

/** The ways bytes are written in the programs and logs they are copied to. */
export const byteFormats = {
  spaced: (pairs: readonly string[]) => pairs.join(' '),
  plain: (pairs: readonly string[]) => pairs.join(''),
  list: (pairs: readonly string[]) => pairs.map((pair) => `0x${pair}`).join(', '),
  c: (pairs: readonly string[]) =>
    `const uint8_t frame[${pairs.length}] = { ${pairs.map((pair) => `0x${pair}`).join(', ')} };`,
  st: (pairs: readonly string[]) => `[${pairs.map((pair) => `16#${pair}`).join(', ')}]`,
  brackets: (pairs: readonly string[]) => pairs.map((pair) => `[0x${pair}]`).join(''),
  escapes: (pairs: readonly string[]) => pairs.map((pair) => `\\x${pair}`).join(''),
  decimal: (pairs: readonly string[]) => pairs.map((pair) => Number.parseInt(pair, 16)).join(', '),
} as const;

export type ByteFormat = keyof typeof byteFormats;

/** Bytes in one of these ways. */
export const writeBytes = (bytes: Uint8Array, format: ByteFormat): string =>
  byteFormats[format](toHex(bytes).match(/../g) ?? []);
