import { readAddressCell } from './address-cell.ts';
import { accessNamed, functionCodes, saysNothing, tableNamed } from './cell-words.ts';
import type { Meaning } from './meaning.ts';
import { readNamesCell } from './names-cell.ts';
import { readRangeCell } from './range-cell.ts';
import { readScaleCell, readUnitCell } from './scale-cell.ts';
import { readOrderCell, readTypeCell, readTypeStart } from './type-cell.ts';

/** Units that are written alone, besides those with a sign that no word has (`°C`, `m/s`, `%`). */
const UNITS = new Set(
  'v,kv,mv,a,ma,ka,w,kw,mw,gw,wh,kwh,mwh,gwh,va,kva,mva,var,kvar,mvar,varh,kvarh,vah,kvah,hz,khz,mhz,rpm,c,f,k,degc,degf,deg,degrees,bar,mbar,pa,kpa,mpa,hpa,psi,s,sec,ms,min,h,hr,hours,minutes,seconds,days,d,l,ml,m,mm,cm,km,kg,g,t,lx,lux,ppm,ppb,j,kj,mj,gj,ohm,ohms,nm,n,count,v ac,v dc,a ac,a dc,ah,°,l/h,l/min,rh,%rh,u/min,1/min,m3,kvah,kw h,db,dbm,year,month,day,hour,minute,second,imp,pulses,℃'.split(
    ',',
  ),
);
const isUnit = (text: string): boolean => {
  const { unit } = readUnitCell(text);
  return (
    unit !== '' &&
    unit.length <= 12 &&
    (UNITS.has(unit.toLowerCase()) || /[°%℃Ω‰µ]|^[a-zA-Z]{1,4}(?:[/·*][a-zA-Z\d³²]{1,4})+$|[a-z][²³]/.test(unit))
  );
};

/** Whether a text is a range of values: `0~80 °C`, `-32768-32767`, `0…100`. */
export const isRange = (text: string): boolean => readRangeCell(text) !== undefined;

const isWhole = (text: string) => /^\d{1,3}$/.test(text);
const isNumber = (text: string) => /^[-+−]?[\d.,]+\s*\S{0,4}$/.test(text);
const hasWords = (text: string) => /\p{L}{2}/u.test(text);
/** `0A` and `0x10` are numbers. */
const hasLetters = (text: string) => /\p{L}/u.test(text) && !/^\d[\da-f]*h?$|^0x[\da-f]+$/i.test(text);

const isAddress = (text: string): boolean =>
  readAddressCell(text, { hex: /^[\da-f]{1,5}$/i.test(text), grouped: true }) !== undefined;

/** Whether a filled cell can stand in a column of a meaning. A sure one is of hardly any other meaning. */
export const fits: Readonly<Record<Meaning, (text: string) => boolean>> = {
  name: hasLetters,
  'other-name': hasLetters,
  group: hasLetters,
  description: hasLetters,
  address: (text) => isAddress(text),
  number: isAddress,
  end: (text) => isAddress(text),
  table: (text) => tableNamed(text) !== undefined || /^[0134]x?$|^0?[1-4]$/.test(text),
  function: (text) => functionCodes(text) !== undefined || tableNamed(text) !== undefined,
  access: (text) => accessNamed(text) !== undefined,
  type: (text) => (readTypeCell(text) ?? readTypeStart(text)) !== undefined,
  order: (text) => readOrderCell(text) !== undefined,
  words: (text) => /^\d{1,3}\s*(?:words?|regs?|registers?|x)?$/i.test(text),
  bytes: (text) => /^\d{1,3}(?:\s*bytes?)?$/i.test(text),
  'bit-size': (text) => /^(?:1|8|16|24|32|48|64|128)(?:\s*bits?)?$/i.test(text),
  count: isWhole,
  factor: (text) => readScaleCell(text) !== undefined,
  divisor: (text) => readScaleCell(text) !== undefined,
  exponent: (text) => /^[-−+]?\d$/.test(text),
  'scale-register': (text) => /^[\p{L}_][\p{L}\d_]*$/u.test(text) || readAddressCell(text) !== undefined,
  offset: (text) => /^[-+−]?(?:\d+(?:[.,]\d+)?|[.,]\d+)$/.test(text),
  decimals: (text) => /^\d$/.test(text),
  unit: (text) => readUnitCell(text).unit.length <= 20 && !/^\d+$/.test(text),
  names: (text) => readNamesCell(text).names.length > 0,
  range: isRange,
  minimum: isNumber,
  maximum: isNumber,
  bit: (text) => /^(?:bit|b)?\s*\d{1,2}(?:\s*[-–.:]+\s*\d{1,2})?$/i.test(text),
  mask: (text) => /^(?:0x[\da-f]+|\d+)$/i.test(text),
  'not-implemented': (text) => /^(?:nan|0x[\da-f]+|[-−]?\d+)$/i.test(text),
  model: () => true,
  index: (text) => /^\d{1,5}\.?$/.test(text),
  other: () => true,
};

/** Meanings that cells alone can show, with the share of cells that must fit. */
export const shownByCells: readonly (readonly [Meaning, number, (text: string) => boolean])[] = [
  // Yes and no may be of anything.
  [
    'access',
    0.9,
    (text) => accessNamed(text) !== undefined && !/^(?:yes|no|true|false|ja|nein|oui|non|s[ií])$/i.test(text),
  ],
  ['type', 0.75, (text) => readTypeCell(text) !== undefined && !/^[a-z]$/i.test(text)],
  ['table', 0.9, (text) => tableNamed(text) !== undefined && text.length > 1],
  ['factor', 0.9, (text) => /^(?:fix\d|raw|enum)$/i.test(text)],
  ['names', 0.5, (text) => readNamesCell(text).names.length > 1],
  ['order', 0.9, (text) => readOrderCell(text) !== undefined && /^[A-H]{2,8}$|endian|swap|[13]\d[24]\d/i.test(text)],
];

/** Whether cells are units, but for some that are names of values. Letters alone may be codes of anything, unless no header says of what. */
export function areUnits(texts: readonly string[], isAlone = false): boolean {
  const plain = texts.filter((text) => readNamesCell(text).names.length === 0);
  return (
    plain.length > 0 &&
    plain.filter(isUnit).length >= plain.length / 2 &&
    (plain.some((text) => text.length > 1 && isUnit(text)) || (isAlone && plain.length > 1 && plain.every(isUnit)))
  );
}

/** Whether a cell says something. */
export const isFilled = (text: string): boolean => !saysNothing(text);
export { hasWords };
