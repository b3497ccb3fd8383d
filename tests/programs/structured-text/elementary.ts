/** The elementary types of the programs, their ranges, and what is converted into what. */
export const BITS: Readonly<Record<string, number>> = { BYTE: 8, WORD: 16, DWORD: 32 };
const WHOLE: Readonly<Record<string, readonly [least: number, most: number]>> = {
  SINT: [-0x80, 0x7f],
  INT: [-0x8000, 0x7fff],
  DINT: [-0x8000_0000, 0x7fff_ffff],
  LINT: [Number.MIN_SAFE_INTEGER, Number.MAX_SAFE_INTEGER],
  USINT: [0, 0xff],
  UINT: [0, 0xffff],
  UDINT: [0, 0xffff_ffff],
};

export const isBits = (type: string): boolean => BITS[type] !== undefined;
export const isWhole = (type: string): boolean => WHOLE[type] !== undefined;
export const isNumeric = (type: string): boolean => isWhole(type) || type === 'LREAL';
export const isElementary = (type: string): boolean =>
  isBits(type) || isNumeric(type) || ['BOOL', 'STRING', 'TIME', 'TON'].includes(type);

/** Whether the type has this number. */
export function holdsNumber(type: string, value: number): boolean {
  const bits = BITS[type];
  if (bits !== undefined) return Number.isInteger(value) && value >= 0 && value < 2 ** bits;
  const range = WHOLE[type];
  return range === undefined ? type === 'LREAL' : Number.isInteger(value) && value >= range[0] && value <= range[1];
}

export const firstOf = (type: string): unknown =>
  type === 'BOOL' ? false : type === 'STRING' ? '' : type === 'TON' ? { since: undefined, Q: false, ET: 0 } : 0;

/**
 * What a conversion does; `undefined` if there is none, or if systems do not agree on what it does: bits become a real number
 * by their value here, and by their form there.
 */
export function conversion(from: string, to: string): ((value: number) => number) | undefined {
  if (from === to) return undefined;
  if (from === 'BOOL') return isBits(to) || isWhole(to) ? (value) => Number(value) : undefined;
  if (isBits(from) && isBits(to)) return (value) => wrapped(to, value);
  if (isBits(from) && isWhole(to)) return (value) => wrapped(to, value);
  if (isWhole(from) && isBits(to)) return (value) => wrapped(to, value);
  if (isWhole(from) && isWhole(to)) return (value) => checked(to, value);
  if (isWhole(from) && to === 'LREAL') return (value) => value;
  if (from === 'LREAL' && isWhole(to)) return (value) => checked(to, Math.sign(value) * Math.round(Math.abs(value)));
  return undefined;
}

/** Whole numbers and real ones are what they are, or the program is wrong. */
export function checked(type: string, value: number): number {
  if (!holdsNumber(type, value)) throw new RangeError(`${value} is no ${type}`);
  return value === 0 ? 0 : value;
}

function wrapped(type: string, value: number): number {
  const bits = BITS[type] ?? Math.log2((WHOLE[type]?.[1] ?? 0) - (WHOLE[type]?.[0] ?? 0) + 1);
  const low = ((value % 2 ** bits) + 2 ** bits) % 2 ** bits;
  return (WHOLE[type]?.[0] ?? 0) < 0 && low >= 2 ** (bits - 1) ? low - 2 ** bits : low;
}
