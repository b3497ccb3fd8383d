import { DEFAULT_GAP } from '../../bus/index.ts';
import { mostRead } from '../../devices/index.ts';
import { Remembered } from '../tools/remembered.ts';

/** How is polled, as chosen last. */
export interface PollSettings {
  readonly from: 'frame' | 'device';
  /** Milliseconds. */
  readonly interval: number;
  readonly unit: number;
  readonly registers: number;
  readonly bits: number;
  readonly gap: number;
  /** What the chart shows: the last so many seconds, 0 for all that is kept. */
  readonly window: number;
  /** The lines that are read, by the profile's id: a line's name, or `name#index` for one value of it. */
  readonly lines: Readonly<Record<string, readonly string[]>>;
}

/** The least and the most of each number. */
export const limits = {
  interval: [0, 86_400_000],
  unit: [1, 255],
  registers: [1, mostRead.registers],
  bits: [1, mostRead.bits],
  gap: [0, mostRead.bits],
  window: [0, 86_400],
} as const;

const usual: PollSettings = {
  from: 'frame',
  interval: 1000,
  unit: 1,
  registers: mostRead.registers,
  bits: mostRead.bits,
  gap: DEFAULT_GAP,
  window: 60,
  lines: {},
};

/** What is stored, as far as it can be used. */
function readSettings(value: unknown): PollSettings {
  const stored = (value ?? {}) as Partial<Record<keyof PollSettings, unknown>>;
  const number = (name: keyof typeof limits) => {
    const [least, most] = limits[name];
    const one = stored[name];
    return typeof one === 'number' && Number.isInteger(one) && one >= least && one <= most ? one : usual[name];
  };
  const lines = Object.entries(typeof stored.lines === 'object' ? (stored.lines ?? {}) : {}).filter(
    (entry): entry is [string, string[]] =>
      Array.isArray(entry[1]) && entry[1].every((name) => typeof name === 'string'),
  );
  return {
    from: stored.from === 'device' ? 'device' : 'frame',
    interval: number('interval'),
    unit: number('unit'),
    registers: number('registers'),
    bits: number('bits'),
    gap: number('gap'),
    window: number('window'),
    lines: Object.fromEntries(lines),
  };
}

export const pollSettings = new Remembered<PollSettings>('poll', usual, readSettings);
