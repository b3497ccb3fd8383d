import { readPairs } from './names-cell.ts';
import { decimal, readUnitCell } from './scale-cell.ts';

/** What a range of values says beside its limits. */
export interface RangeReading {
  /** The minimum is negative. */
  readonly signed: boolean;
  readonly unit: string;
  /** What raw numbers are multiplied by: `50~350 (5,0~35,0 °C)`, or the last digit that the limits have. */
  readonly factor?: number;
}

const NUMBER = String.raw`[-−+]?\s?\d+(?:[.,'’]\d+)?`;
const UNIT = String.raw`[^\d\s()~–…]{0,8}`;
const SPAN = String.raw`(${NUMBER})\s*(${UNIT})\s*(?:-|–|—|−|~|～|to|bis|à|…|\.\.+|至|÷)\s*(${NUMBER})\s*(${UNIT})`;
const LIMITS = new RegExp(String.raw`^\s*\[\s*(${NUMBER})\s*(${UNIT})\s*[,;]\s*(${NUMBER})\s*(${UNIT})\s*\]\s*$`, 'iu');
const RANGE = new RegExp(String.raw`^\s*[[(]?\s*${SPAN}\s*[\])]?\s*(?:[([]\s*${SPAN}\s*[\])])?\s*$`, 'iu');
const LONGEST = 80;

const numberOf = (text: string): number => decimal(text.replace(/\s/g, '').replace(/['’]/, '.'));
const digitsBehind = (text: string): number => /[.,'’](\d+)$/.exec(text.trim())?.[1]?.length ?? 0;

/** Reads a range: `0~80 °C`, `-32768-32767`, `50~350 (5,0~35,0 °C)`; `undefined` for any other text. */
export function readRangeCell(text: string): RangeReading | undefined {
  if (text.length > LONGEST || !/\d/.test(text)) return undefined;
  const plain = text.replace(/(\d)[\s\u00a0](?=\d{3}\b)/g, '$1');
  const found = RANGE.exec(plain) ?? LIMITS.exec(plain);
  if (!found || readPairs(text).names.length > 0) return undefined;
  const [, least = '', unit = '', most = '', unitBehind = '', , innerUnit = '', innerMost, innerUnitBehind = ''] =
    found;
  const said = [innerUnitBehind, innerUnit, unitBehind, unit].find((one) => one !== '') ?? '';
  const signed = /^[-−]/.test(least.trim());
  const scale = innerMost === undefined ? undefined : ratio(numberOf(most), numberOf(innerMost));
  const digits = Math.max(digitsBehind(least), digitsBehind(most));
  const factor = scale ?? (innerMost === undefined && digits > 0 ? 10 ** -digits : undefined);
  return { signed, unit: readUnitCell(said).unit, ...(factor === undefined ? {} : { factor }) };
}

/** The power of ten between the two forms of one limit, of which the smaller one is in units. */
function ratio(one: number, other: number): number | undefined {
  const power = Math.log10(Math.abs(one / other));
  const whole = Math.round(power);
  return Number.isFinite(power) && whole !== 0 && Math.abs(power - whole) < 1e-9 ? 10 ** -Math.abs(whole) : undefined;
}
