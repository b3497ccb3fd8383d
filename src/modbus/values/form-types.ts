import { hexDigits } from '../hex.ts';
import { type Moment, millisecondsOf, momentOf, momentText, readMoment, weekdayOf } from './kernels/dates.ts';

/** A type whose value is a text of a form: a date, an address, a power factor with its quadrant. */
export interface FormType {
  readonly registers: number;
  /** `undefined` if the bytes, high byte first, hold no such value. */
  read(view: DataView): string | undefined;
  /** `false` if the text has not the form, or the type does not hold it. */
  write(view: DataView, text: string): boolean;
}

const bytesOf = (view: DataView): readonly number[] =>
  Array.from({ length: view.byteLength }, (_, at) => view.getUint8(at));

const setBytes = (view: DataView, bytes: readonly number[]): boolean => {
  const fits = bytes.length === view.byteLength && bytes.every((byte) => byte >= 0 && byte <= 0xff);
  if (fits) for (const [at, byte] of bytes.entries()) view.setUint8(at, byte);
  return fits;
};

/** A date by parts of registers. */
const dated = (
  registers: number,
  read: (bytes: readonly number[]) => Moment | undefined,
  write: (moment: Moment) => readonly number[],
): FormType => ({
  registers,
  read: (view) => {
    const moment = read(bytesOf(view));
    return moment && momentText(moment);
  },
  write: (view, text) => {
    const moment = readMoment(text);
    return moment !== undefined && setBytes(view, write(moment));
  },
});

/** Seconds or milliseconds since 1970. */
const unix = (registers: 2 | 4, each: 1 | 1000): FormType => ({
  registers,
  read: (view) => {
    const count = registers === 2 ? view.getUint32(0) : Number(view.getBigUint64(0));
    const moment = momentOf(count * each);
    const text = moment && momentText(moment);
    return text === undefined ? undefined : `${text}Z`;
  },
  write: (view, text) => {
    const moment = readMoment(text);
    const at = moment && millisecondsOf(moment);
    if (at === undefined || at < 0 || Math.floor(at / each) >= 2 ** (16 * registers)) return false;
    if (registers === 2) view.setUint32(0, Math.floor(at / each));
    else view.setBigUint64(0, BigInt(Math.floor(at / each)));
    return true;
  },
});

/** Two decimal digits of a byte; 255 where one is above 9. */
const decimal = (byte: number): number => (byte >> 4 > 9 || (byte & 15) > 9 ? 255 : 10 * (byte >> 4) + (byte & 15));
const digits = (value: number): number => (Math.floor(value / 10) << 4) | (value % 10);

/** Bytes without a number: MAC and IP addresses. */
const joined = (registers: number, separator: string, base: 10 | 16): FormType => ({
  registers,
  read: (view) =>
    bytesOf(view)
      .map((byte) => (base === 10 ? String(byte) : hexDigits(byte, 2)))
      .join(separator),
  write: (view, text) => {
    const parts = text.trim().split(base === 10 ? '.' : /[:-]/);
    const form = base === 10 ? /^\d{1,3}$/ : /^[\da-f]{1,2}$/i;
    return (
      parts.every((part) => form.test(part)) &&
      setBytes(
        view,
        parts.map((part) => Number.parseInt(part, base)),
      )
    );
  },
});

/** More than a power factor, by which a quadrant is told. */
const POWER_FACTOR = /^([-−]?)(0(?:\.\d+)?|1(?:\.0+)?)\s*(lead|lag)?(?:ing)?$/i;

export const formTypes = {
  /** IEC 870-5-4 (TI081 of Schneider): year, month with day of the week and day, hour and minute, milliseconds. */
  timeiec: dated(
    4,
    ([, year = 0, month = 0, day = 0, hour = 0, minute = 0, high = 0, low = 0]) => {
      const ms = 256 * high + low;
      const date = [2000 + (year & 0x7f), month & 0x0f, day & 0x1f] as const;
      return [...date, hour & 0x1f, minute & 0x3f, Math.floor(ms / 1000), ms % 1000];
    },
    (moment) => {
      const [year, month, day, hour, minute, second, ms] = moment;
      const all = 1000 * second + ms;
      const isHeld = year >= 2000 && year <= 2127;
      return [0, isHeld ? year - 2000 : -1, month, (weekdayOf(moment) << 5) | day, hour, minute, all >> 8, all & 0xff];
    },
  ),
  /** Byte pairs: year of the century and month, day and hour, minute and second. */
  timeymd: dated(
    3,
    ([year = 0, month = 0, day = 0, hour = 0, minute = 0, second = 0]) =>
      year > 99 ? undefined : [2000 + year, month, day, hour, minute, second, 0],
    ([year, ...rest]) => [year <= 2099 ? year - 2000 : -1, ...rest.slice(0, 5)],
  ),
  /** Byte pairs of PowerLogic: month and day, year since 1900 and hour, minute and second. */
  timemdy: dated(
    3,
    ([month = 0, day = 0, year = 0, hour = 0, minute = 0, second = 0]) => [
      1900 + year,
      month,
      day,
      hour,
      minute,
      second,
      0,
    ],
    ([year, month, day, hour, minute, second]) => [month, day, year - 1900, hour, minute, second],
  ),
  /** Two decimal digits a byte: year of the century, month, day, hour, minute, second. */
  timebcd: dated(
    3,
    (bytes) => {
      const [year = 255, month = 0, day = 0, hour = 0, minute = 0, second = 0] = bytes.map(decimal);
      return year > 99 ? undefined : [2000 + year, month, day, hour, minute, second, 0];
    },
    ([year, ...rest]) => (year >= 2000 && year <= 2099 ? [year - 2000, ...rest.slice(0, 5)].map(digits) : []),
  ),
  /** Seconds since 1970. */
  timeunix: unix(2, 1000),
  timeunix64: unix(4, 1000),
  /** Milliseconds since 1970. */
  timeunixms: unix(4, 1),
  /** IPv4. */
  ip: joined(2, '.', 10),
  mac: joined(3, ':', 16),
  /**
   * A power factor in four quadrants as a float (PM5000 of Schneider, “4Q FP PF”): a number beyond ±1 is leading, 2 or −2 less the
   * factor.
   */
  pf4q: {
    registers: 2,
    read: (view) => {
      const got = view.getFloat32(0);
      const isLeading = Math.abs(got) > 1;
      const factor = isLeading ? Math.sign(got) * 2 - got : got;
      if (!(Math.abs(got) <= 2)) return undefined;
      const text = String(Number(factor.toPrecision(6)));
      return Math.abs(factor) === 1 ? text : `${text} ${isLeading ? 'lead' : 'lag'}`;
    },
    write: (view, text) => {
      const [, sign, size, quadrant = 'lag'] = POWER_FACTOR.exec(text.trim()) ?? [];
      if (size === undefined) return false;
      const factor = (sign ? -1 : 1) * Number(size);
      const isLeading = quadrant.toLowerCase() === 'lead' && Math.abs(factor) < 1;
      view.setFloat32(0, isLeading ? (sign ? -2 : 2) - factor : factor);
      return true;
    },
  },
} as const satisfies Readonly<Record<string, FormType>>;

export type FormTypeName = keyof typeof formTypes;

/** Texts, which have any length; UTF-8 has ASCII in it. */
export const textTypes = {
  text: 'utf-8',
  latin1: 'latin-1',
  /** One character a register, in its low byte. */
  chars: 'wide',
} as const;

export type TextTypeName = keyof typeof textTypes;
