import { toHex } from '../modbus/index.ts';

type Pairs = readonly string[];

const inC = (pairs: Pairs) => pairs.map((pair) => `0x${pair}`).join(', ');
const capital = (word: string) => word.charAt(0).toUpperCase() + word.slice(1);
/** `writeP0683_30Hz`: numbers do not run together. */
const camel = (words: readonly string[]) =>
  words.reduce(
    (name, word) => `${name}${/\d$/.test(name) && /^\d/.test(word) ? '_' : ''}${name === '' ? word : capital(word)}`,
    '',
  );

/**
 * The ways bytes are written in the programs and logs they are copied to, the commonest first. `name` is what a program calls
 * them, in words of letters and digits.
 */
export const byteFormats = {
  spaced: (pairs: Pairs) => pairs.join(' '),
  c: (pairs: Pairs, name: readonly string[]) => `const uint8_t ${name.join('_')}[${pairs.length}] = { ${inC(pairs)} };`,
  arduino: (pairs: Pairs, name: readonly string[]) => `const byte ${camel(name)}[] = { ${inC(pairs)} };`,
  csharp: (pairs: Pairs, name: readonly string[]) => `byte[] ${camel(name)} = { ${inC(pairs)} };`,
  st: (pairs: Pairs, name: readonly string[]) =>
    `${capital(camel(name))} : ARRAY[0..${pairs.length - 1}] OF BYTE := [${pairs.map((pair) => `16#${pair}`).join(', ')}];`,
  python: (pairs: Pairs, name: readonly string[]) => `${name.join('_')} = bytes([${inC(pairs)}])`,
  javascript: (pairs: Pairs, name: readonly string[]) => `const ${camel(name)} = Uint8Array.of(${inC(pairs)});`,
  list: inC,
  plain: (pairs: Pairs) => pairs.join(''),
  decimal: (pairs: Pairs) => pairs.map((pair) => Number.parseInt(pair, 16)).join(', '),
  escapes: (pairs: Pairs) => pairs.map((pair) => `\\x${pair}`).join(''),
  brackets: (pairs: Pairs) => pairs.map((pair) => `[0x${pair}]`).join(''),
} as const;

export type ByteFormat = keyof typeof byteFormats;

/** Bytes in one of these ways. No bytes give an empty text, because some programs cannot write an empty array. */
export function writeBytes(bytes: Uint8Array, format: ByteFormat, name: readonly string[] = ['frame']): string {
  const pairs = toHex(bytes).match(/../g);
  return pairs ? byteFormats[format](pairs, name) : '';
}
