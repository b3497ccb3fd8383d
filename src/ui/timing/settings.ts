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
import type { InputError } from '../../workbench/index.ts';
import { Remembered } from '../tools/remembered.ts';

/** What is typed and chosen, as it stands in the address. */
export interface Texts {
  /** Empty: the mode of the frame at hand. */
  readonly mode: string;
  readonly baud: string;
  readonly format: string;
  /** By which bits silences are counted: `format` for those of the format, or 11. */
  readonly counted: string;
  /** Characters of the request and the reply; empty: those of the frame at hand. */
  readonly request: string;
  readonly reply: string;
  readonly delay: string;
  readonly turnaround: string;
  readonly devices: string;
  readonly missing: string;
  readonly timeout: string;
  readonly gap: string;
}

export type Name = keyof Texts;

const initial: Texts = {
  mode: '',
  baud: '19200',
  format: '8E1',
  counted: 'format',
  request: '',
  reply: '',
  delay: '0 ms',
  turnaround: '100 ms',
  devices: '10',
  missing: '0',
  timeout: '1 s',
  gap: '1 ms',
};
const names = Object.keys(initial) as Name[];

/** What belongs to the frame at hand, and not to the line. */
const OF_THE_FRAME: readonly Name[] = ['mode', 'request', 'reply'];

/** The line and the devices as typed last. */
const lastTexts = new Remembered<Texts>('timing', initial, (value) => {
  const held = (value ?? {}) as Partial<Record<Name, unknown>>;
  return read((name) => (typeof held[name] === 'string' ? held[name] : undefined), initial);
});

function read(textOf: (name: Name) => string | undefined, otherwise: Texts): Texts {
  const entries = names.map((name) => [name, textOf(name) ?? otherwise[name]]);
  return Object.fromEntries(entries) as unknown as Texts;
}

/** The texts of an address; what it leaves out is as typed last. */
export const textsOf = (query: URLSearchParams): Texts => read((name) => query.get(name) ?? undefined, lastTexts.value);

/** Keeps the texts for the next time. */
export function remember(texts: Texts): void {
  lastTexts.value = read((name) => (OF_THE_FRAME.includes(name) ? '' : texts[name]), initial);
}

/** What a text comes to, or why it comes to nothing. */
export type Entry<T = number> = { readonly value: T } | { readonly error: InputError };

export const knownOf = <T>(entry: Entry<T>): T | undefined => ('value' in entry ? entry.value : undefined);
export const errorOf = <T>(entry: Entry<T>): InputError | undefined => ('error' in entry ? entry.error : undefined);

export const LEAST_BAUD = 300;
export const MOST_BAUD = 4_000_000;
const HOUR = 3_600_000_000;

function whole(text: string, least: number, most: number): Entry {
  if (text.trim() === '') return { error: { code: 'field-missing' } };
  const got = readNumber(text);
  if (got === undefined) return { error: { code: 'not-a-number', text } };
  const fits = Number.isInteger(got) && got >= least && got <= most;
  return fits ? { value: got } : { error: { code: 'number-out-of-range', got, least, most } };
}

/** The line as set, and what follows from it alone. */
export interface SetLine extends SerialLine {
  /** Bits of a character. */
  readonly bits: number;
  /** Bits of the characters by which silences are counted. */
  readonly countedBits: number;
  readonly silences: Silences;
}

/** The format chosen; a link may name one that is none. */
export const formatOf = ({ format }: Texts): SerialFormat =>
  readSerialFormat(format) ?? (readSerialFormat(initial.format) as SerialFormat);

export const modeOf = ({ mode }: Texts, ofFrame: string): SerialMode =>
  (mode === '' ? ofFrame : mode) === 'ascii' ? 'ascii' : 'rtu';

export const baudOf = ({ baud }: Texts): Entry => whole(baud, LEAST_BAUD, MOST_BAUD);

export function lineOf(texts: Texts): SetLine | undefined {
  const baud = knownOf(baudOf(texts));
  if (baud === undefined) return undefined;
  const format = formatOf(texts);
  const bits = bitsPerCharacter(format);
  const countedBits = countedOf(texts) === '11' ? RTU_CHARACTER_BITS : bits;
  return { ...format, baud, bits, countedBits, silences: rtuSilences(baud, countedBits) };
}

/** By which bits silences are counted; a link may say anything. */
export const countedOf = ({ counted }: Texts): 'format' | '11' => (counted === '11' ? '11' : 'format');

/** Whether it matters by how many bits silences are counted. */
export const canCount = (texts: Texts, mode: SerialMode): boolean =>
  mode === 'rtu' &&
  bitsPerCharacter(formatOf(texts)) !== RTU_CHARACTER_BITS &&
  !hasFixedSilences(knownOf(baudOf(texts)) ?? 0);

/** A time in microseconds; bits and characters are those of the line. */
export function timeOf(text: string, line: SetLine | undefined): Entry {
  if (text.trim() === '') return { error: { code: 'field-missing' } };
  const duration = readDuration(text);
  const error = { code: 'not-a-time', text } as const;
  if (duration === undefined) return { error };
  const { amount, unit } = duration;
  // Without a speed nobody knows how long a bit is, and the speed is what is to be corrected.
  const bit = line ? bitsTime(line.baud, 1) : 0;
  const units = { us: 1, ms: 1000, s: 1_000_000, bits: bit, characters: bit * (line?.bits ?? 0) };
  const value = amount * units[unit];
  return value <= HOUR ? { value } : { error };
}

export const devicesOf = ({ devices }: Texts): Entry => whole(devices, BROADCAST + 1, LAST_UNIT);
export const missingOf = ({ missing }: Texts, devices: number): Entry => whole(missing, 0, devices);

/** The number of characters typed, or that of the frame at hand where none is. */
export function charactersOf(
  text: string,
  mode: SerialMode,
  least: number,
  atHand: number | undefined,
): Entry<number | undefined> {
  return text.trim() === '' ? { value: atHand } : whole(text, least, mode === 'rtu' ? MOST_RTU : MOST_ASCII);
}
