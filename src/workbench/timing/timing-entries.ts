import {
  BROADCAST,
  bitsPerCharacter,
  bitsTime,
  hasFixedSilences,
  LAST_UNIT,
  MOST_ASCII,
  MOST_RTU,
  RTU_CHARACTER_BITS,
  readSerialFormat,
  rtuSilences,
  type SerialFormat,
  type SerialLine,
  type SerialMode,
  type Silences,
} from '../../modbus/index.ts';
import { readDuration, readNumber } from '../../notation/index.ts';
import type { InputError } from '../frame/input-error.ts';
import { LEAST_BAUD, MOST_BAUD } from '../line/line-setting.ts';

/** What is typed and chosen, as the address has it. */
export interface TimingTexts {
  /** Empty: the mode of the current frame. */
  readonly mode: string;
  readonly baud: string;
  readonly format: string;
  /** By which bits silences are counted: `format` for those of the format, or 11. */
  readonly counted: string;
  /** Characters of the request and the reply; empty: those of the current frame. */
  readonly request: string;
  readonly reply: string;
  readonly delay: string;
  readonly turnaround: string;
  readonly devices: string;
  readonly missing: string;
  readonly timeout: string;
  readonly gap: string;
}

export type TimingName = keyof TimingTexts;

/** The value of a text, or why it has none. */
export type Entry<T = number> = { readonly value: T } | { readonly error: InputError };

export const knownOf = <T>(entry: Entry<T>): T | undefined => ('value' in entry ? entry.value : undefined);
export const errorOf = <T>(entry: Entry<T>): InputError | undefined => ('error' in entry ? entry.error : undefined);

const HOUR = 3_600_000_000;

function whole(text: string, least: number, most: number): Entry {
  if (text.trim() === '') return { error: { code: 'field-missing' } };
  const got = readNumber(text);
  if (got === undefined) return { error: { code: 'not-a-number', text } };
  const fits = Number.isInteger(got) && got >= least && got <= most;
  return fits ? { value: got } : { error: { code: 'number-out-of-range', got, least, most } };
}

/** Whether a text is a whole number from `least` to `most`. */
export const isWhole = (text: string, least: number, most: number): boolean => 'value' in whole(text, least, most);

/** The line as set, and what follows from it alone. */
export interface SetLine extends SerialLine {
  /** Bits of a character. */
  readonly bits: number;
  /** Bits of the characters by which silences are counted. */
  readonly countedBits: number;
  readonly silences: Silences;
}

/** The default of the specification (SL 2.5.1). */
const DEFAULT_FORMAT: SerialFormat = { dataBits: 8, parity: 'even', stopBits: 1 };

/** The format chosen; the default if a link names one that does not exist. */
export const timingFormat = ({ format }: Pick<TimingTexts, 'format'>): SerialFormat =>
  readSerialFormat(format) ?? DEFAULT_FORMAT;

export const timingMode = ({ mode }: TimingTexts, ofFrame: string): SerialMode =>
  (mode === '' ? ofFrame : mode) === 'ascii' ? 'ascii' : 'rtu';

export const baudEntry = ({ baud }: TimingTexts): Entry => whole(baud, LEAST_BAUD, MOST_BAUD);

export function timingLine(texts: TimingTexts): SetLine | undefined {
  const baud = knownOf(baudEntry(texts));
  if (baud === undefined) return undefined;
  const format = timingFormat(texts);
  const bits = bitsPerCharacter(format);
  const countedBits = countedBy(texts) === '11' ? RTU_CHARACTER_BITS : bits;
  return { ...format, baud, bits, countedBits, silences: rtuSilences(baud, countedBits) };
}

/** By which bits silences are counted; a link may say anything. */
export const countedBy = ({ counted }: TimingTexts): 'format' | '11' => (counted === '11' ? '11' : 'format');

/** Whether it matters by how many bits silences are counted. */
export const canCount = (texts: TimingTexts, mode: SerialMode): boolean =>
  mode === 'rtu' &&
  bitsPerCharacter(timingFormat(texts)) !== RTU_CHARACTER_BITS &&
  !hasFixedSilences(knownOf(baudEntry(texts)) ?? 0);

/** Whether a text is a time, on whatever line. */
export const isTime = (text: string): boolean => 'value' in timeEntry(text, undefined);

/** A time in microseconds; bits and characters are those of the line. */
export function timeEntry(text: string, line: SetLine | undefined): Entry {
  if (text.trim() === '') return { error: { code: 'field-missing' } };
  const duration = readDuration(text);
  const error = { code: 'not-a-time', text } as const;
  if (duration === undefined) return { error };
  const { amount, unit } = duration;
  // Without a speed the length of a bit is unknown, and it is the speed that has to be corrected.
  const bit = line ? bitsTime(line.baud, 1) : 0;
  const units = { us: 1, ms: 1000, s: 1_000_000, bits: bit, characters: bit * (line?.bits ?? 0) };
  const value = amount * units[unit];
  return value <= HOUR ? { value } : { error };
}

export const devicesEntry = ({ devices }: TimingTexts): Entry => whole(devices, BROADCAST + 1, LAST_UNIT);
export const missingEntry = ({ missing }: TimingTexts, devices: number): Entry => whole(missing, 0, devices);

/** The number of characters typed; `known` if nothing is typed. */
export function charactersEntry(
  text: string,
  mode: SerialMode,
  least: number,
  known: number | undefined,
): Entry<number | undefined> {
  return text.trim() === '' ? { value: known } : whole(text, least, mode === 'rtu' ? MOST_RTU : MOST_ASCII);
}
