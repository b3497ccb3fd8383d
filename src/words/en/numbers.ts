import { hexDigits } from '../../modbus/index.ts';
import { formatHex } from '../../notation/index.ts';

const MEGA = 1_000_000;

/** A size in kB, or from 1 MB on in MB. */
export const sizeOf = (bytes: number) =>
  bytes < MEGA ? `${Math.ceil(bytes / 1000)} kB` : `${(bytes / MEGA).toFixed(1)} MB`;

/** A byte as hexadecimal digits alone, as in a frame. */
export const byteHex = (value: number) => hexDigits(value, 2);

export const byte = (value: number) => formatHex(value, 2);

/** A function code in both bases: `16 (0x10)`, as the specification's headings have it; `03` where both are the same. */
export const code = (value: number) => (value < 10 ? byteHex(value) : `${value} (${byte(value)})`);

/** A function with a part of it that has a code of its own: `43/14 (0x2B/0x0E)`, `08/10 (0x08/0x0A)`. */
export const codeWithin = (of: number, part: number) =>
  of < 10 && part < 10
    ? `${byteHex(of)}/${byteHex(part)}`
    : `${padded(of)}/${padded(part)} (${byte(of)}/${byte(part)})`;

const padded = (value: number) => String(value).padStart(2, '0');
export const word = (value: number) => formatHex(value, 4);

const plurals = new Intl.PluralRules('en');
const numbers = new Intl.NumberFormat('en');
const lists = new Intl.ListFormat('en');

/** A large number with its thousands apart: `12,345`. */
export const grouped = (count: number) => numbers.format(count);

export const plural = (count: number, one: string, many = `${one}s`) =>
  `${grouped(count)} ${plurals.select(count) === 'one' ? one : many}`;

/** A number in words that count bytes. */
export const bytesOf = (count: number) => plural(count, 'byte');

/** `1, 2, and 3`. */
export const all = (names: readonly (string | number)[]) => lists.format(names.map(String));
