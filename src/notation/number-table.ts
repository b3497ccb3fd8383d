import { formatHex } from './number.ts';

/** The languages that a table of numbers is written in. */
export type TableLanguage = 'c' | 'st';

/** Numbers in a line. */
const LINE = 8;

const sizes = [
  { bits: 8, c: 'uint8_t', st: 'BYTE' },
  { bits: 16, c: 'uint16_t', st: 'WORD' },
  { bits: 32, c: 'uint32_t', st: 'DWORD' },
];

/** Numbers of up to 32 bits as a constant array for a program in C, or a variable for one in Structured Text. */
export function writeNumberTable(
  name: string,
  values: ArrayLike<number>,
  bits: number,
  language: TableLanguage,
): string {
  const size = sizes.find((each) => each.bits >= bits) ?? sizes[2];
  const number = (value: number) => {
    const hex = formatHex(value, Math.ceil(bits / 4));
    return language === 'c' ? hex : hex.replace('0x', '16#');
  };
  const numbers = Array.from(values, number);
  const lines = Array.from(
    { length: Math.ceil(numbers.length / LINE) },
    (_, line) => `  ${numbers.slice(line * LINE, (line + 1) * LINE).join(', ')}`,
  ).join(',\n');
  return language === 'c'
    ? `static const ${size?.c} ${name}[${numbers.length}] = {\n${lines}\n};`
    : `${name} : ARRAY[0..${numbers.length - 1}] OF ${size?.st} := [\n${lines}\n];`;
}
