import {
  bitsPerCharacter,
  bitsTime,
  type Parity,
  parities,
  readSerialFormat,
  rtuSilences,
  type SerialLine,
  type Silences,
  serialFormatName,
} from '../../modbus/index.ts';
import { readSpeed } from '../line/line-setting.ts';

/** The times by which a line goes, in microseconds (SL 2.5.1.1). */
export interface AskedTiming extends Silences {
  readonly tool: 'timing';
  readonly line: SerialLine;
  readonly character: number;
  /** What the Timing view is to show. */
  readonly parts: Readonly<Record<string, string>>;
  /** A number of the text that no line has. */
  readonly wrong?: string;
}

/** What a clause says: something of the line, a time, or nothing but the subject. */
interface Said {
  readonly line?: Partial<SerialLine>;
  readonly texts?: Readonly<Record<string, string>>;
}

/** A clause by its pattern; `undefined` if what it found says nothing legal. `open` alone does not make the subject. */
interface Clause {
  readonly pattern: RegExp;
  readonly read: (found: RegExpExecArray) => Said | undefined;
  readonly open?: true;
}

/** Milliseconds without a unit; a number before a format is a speed. */
const TIME = String.raw`(\d+(?:[.,]\d+)?(?:\s*(?:[uµμ]s|ms|s|bits?|chars?|characters?)(?!\w)|(?![\d.,\w]|\s*[5-8]\s?[-,/]?\s?[neo])))`;
const SPEED = String.raw`(\d+(?:[.,]\d+)?\s*k?)`;

const timed = (name: 'timeout' | 'turnaround' | 'delay' | 'gap', words: string): Clause => ({
  pattern: new RegExp(String.raw`(?<!\w)(?:${words})(?:\s*[:=]?\s*${TIME})?(?!\w)`, 'i'),
  read: ([, time]) => (time === undefined ? {} : { texts: { [name]: time } }),
});

const speed = (text: string | undefined): Said | undefined => {
  const [, number = '', k] = /^(\d+(?:[.,]\d+)?)\s*(k?)$/i.exec(text ?? '') ?? [];
  const baud = readSpeed(String(Math.round(Number(number.replace(',', '.')) * (k ? 1000 : 1))));
  return baud === undefined ? undefined : { line: { baud } };
};

const parityOf = (text = ''): Parity | undefined =>
  parities.find((one) => one === text.toLowerCase().replace(/^no$/, 'none'));

const CLAUSES: readonly Clause[] = [
  { pattern: /(?<!\w)t\s?[13][.,]?5(?![\d.])/i, read: () => ({}) },
  {
    pattern:
      /(?<!\w)(?:silen(?:t|ce)s?(?:\s+(?:intervals?|times?))?|inter-?\s?frame(?:\s+(?:gap|delay|time|spacing))?|(?:char(?:acter)?|bit)\s+time|timings?)(?!\w)/i,
    read: () => ({}),
  },
  {
    pattern: new RegExp(
      String.raw`(?<!\w)(?:baud\s?rate|baud|bps|(?:line|serial)\s+speed)\s*[:=]?\s*${SPEED}(?![\w.])`,
      'i',
    ),
    read: ([, number]) => speed(number),
  },
  {
    pattern: new RegExp(
      String.raw`(?<![\w.])${SPEED}\s*(?:bauds?|bd|bps|bits?\/s|bits?\s+(?:per|a)\s+second)(?!\w)`,
      'i',
    ),
    read: ([, number]) => speed(number),
  },
  timed('timeout', String.raw`(?:response\s+)?time-?\s?out`),
  timed('turnaround', String.raw`turn-?\s?around(?:\s+(?:delay|time))?`),
  timed('delay', String.raw`(?:response|reply)\s+(?:delay|time)`),
  timed('gap', String.raw`inter-?\s?char(?:acter)?(?:\s+(?:gap|delay|time|timeout))?|gap`),
  { pattern: /(?<!\w)(?:baud\s?rate|baud)(?!\w)/i, read: () => ({}) },
  inFormat('[no]'),
  // `8E1` alone may be a number.
  { ...inFormat('e'), open: true },
  {
    pattern: /(?<!\w)(?:parity\s*[:=]?\s*(none|no|even|odd)|(none|no|even|odd)\s+parity|parity)(?!\w)/i,
    read: ([, behind, before]) => {
      const parity = parityOf(behind ?? before);
      return parity === undefined ? {} : { line: { parity } };
    },
  },
  {
    pattern: /(?<!\w)(?:stop\s?bits?\s*[:=]?\s*([12])|([12])\s*stop\s?bits?|stop\s?bits?)(?!\w)/i,
    read: ([, behind, before]) =>
      (behind ?? before) ? { line: { stopBits: (behind ?? before) === '2' ? 2 : 1 } } : {},
  },
  {
    pattern: /(?<!\w)(?:data\s?bits?\s*[:=]?\s*([78])|([78])\s*data\s?bits?|data\s?bits?)(?!\w)/i,
    read: ([, behind, before]) =>
      (behind ?? before) ? { line: { dataBits: (behind ?? before) === '7' ? 7 : 8 } } : {},
  },
  // A number alone is a speed beside what else is said of a line.
  {
    pattern: new RegExp(String.raw`(?<![\w.])${SPEED}(?![\w.])`, 'i'),
    read: ([, number]) => speed(number),
    open: true,
  },
];

/** The format of a character with such a parity. */
function inFormat(parity: string): Clause {
  return {
    pattern: new RegExp(String.raw`(?<!\w)([5-8])\s?[-,/]?\s?(${parity})\s?[-,/]?\s?([12])(?!\w)`, 'i'),
    read: (found) => {
      const format = readSerialFormat(found.slice(1).join('').toUpperCase());
      return format && { line: format };
    },
  };
}

const FILLERS =
  /(?<!\w)(?:what|is|the|a|at|of|for|in|on|and|with|how|long|are|modbus|rtu|serial|line|rate)(?!\w)|[\s,;:=/-]+/gi;

/**
 * Reads what is said of a line and its times, and nothing else: `t3.5 9600 8N1`, `baud 19200`, `parity even`, `turnaround 100 ms`.
 * What the text leaves open of the line is as in `present`.
 */
export function timingAsked(typed: string, present: SerialLine): AskedTiming | undefined {
  let rest = typed;
  let isSubject = false;
  let open = 0;
  let said: Partial<SerialLine> = {};
  let texts: Said['texts'] = {};
  for (const { pattern, read, open: isOpen } of CLAUSES) {
    const found = pattern.exec(rest);
    const clause = found ? read(found) : undefined;
    if (found === null || clause === undefined) continue;
    rest = `${rest.slice(0, found.index)} ${rest.slice(found.index + found[0].length)}`;
    said = { ...said, ...clause.line };
    texts = { ...texts, ...clause.texts };
    isSubject ||= !isOpen;
    open += isOpen ? 1 : 0;
  }
  const [wrong, ...more] = rest.split(FILLERS).filter((word) => word !== undefined && word !== '');
  // A speed with a format is a line, though each by itself may be something else.
  const isAsked =
    wrong === undefined ? isSubject || open > 1 : isSubject && more.length === 0 && /^\d+k?$/i.test(wrong);
  if (!isAsked) return undefined;
  const { baud, dataBits, parity, stopBits } = { ...present, ...said };
  const line = { baud, dataBits, parity, stopBits };
  const bits = bitsPerCharacter(line);
  return {
    tool: 'timing',
    line,
    character: bitsTime(baud, bits),
    ...rtuSilences(baud, bits),
    parts: { baud: String(baud), format: serialFormatName(line), ...texts },
    ...(wrong !== undefined && { wrong }),
  };
}
