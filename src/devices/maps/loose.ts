/** A value that a file of JSON, YAML or TOML gave, of which nothing is known. */
export type Loose = Readonly<Record<string, unknown>>;

export const isObject = (value: unknown): value is Loose =>
  typeof value === 'object' && value !== null && !Array.isArray(value);

export const isScalar = (value: unknown): boolean => typeof value !== 'object' || value === null;

/** The objects in a list; of anything else, none. */
export const objectsIn = (value: unknown): readonly Loose[] => (Array.isArray(value) ? value.filter(isObject) : []);

/** The own value under a key, or `undefined`. */
export const valueAt = (value: unknown, key: string): unknown =>
  isObject(value) && Object.hasOwn(value, key) ? value[key] : undefined;

/** A scalar as text, numbers without an exponent; lists joined with commas; of anything else, nothing. */
export function textOf(value: unknown): string {
  if (typeof value === 'string') return value;
  if (typeof value === 'number') return numberText(value);
  if (typeof value === 'boolean' || typeof value === 'bigint') return String(value);
  return Array.isArray(value) ? value.filter(isScalar).map(textOf).join(', ') : '';
}

/** A number as its shortest digits, without an exponent. */
export function numberText(value: number): string {
  const short = String(value);
  const [, sign = '', whole = '', part = '', exponent = ''] = /^(-?)(\d)(?:\.(\d+))?e([+-]\d+)$/.exec(short) ?? [];
  if (whole === '') return short;
  const digits = whole + part;
  const point = 1 + Number(exponent);
  if (point <= 0) return `${sign}0.${'0'.repeat(-point)}${digits}`;
  return sign + digits.padEnd(point, '0');
}

/** A number that is one, or a text that is one in decimal or with `0x`; `undefined` of anything else. */
export function numberOf(value: unknown): number | undefined {
  if (typeof value === 'number') return value;
  if (typeof value !== 'string' || !/^\s*(?:[+-]?(?:\d+(?:\.\d*)?|\.\d+)(?:e[+-]?\d+)?|0x[\da-f]+)\s*$/i.test(value))
    return undefined;
  return Number(value);
}

/** A key as it is looked up: letters and digits alone, in lower case. */
export const plainKey = (key: string): string => key.toLowerCase().replace(/[^\p{L}\d]/gu, '');
