import { DEFAULT_GAP } from '../../bus/index.ts';
import { mostRead } from '../../devices/index.ts';
import { byName, listOf, oneOf, record, text, whole } from '../stored.ts';

/** The settings of the poll. */
export interface PollSettings {
  readonly from: 'frame' | 'device';
  /** Milliseconds. */
  readonly interval: number;
  readonly unit: number;
  readonly registers: number;
  readonly bits: number;
  readonly gap: number;
  /** How many of the last seconds the chart shows; 0 for everything that is kept. */
  readonly window: number;
  /** The lines that are read, by the profile's id: a line's name, or `name#index` for one value of it. */
  readonly lines: Readonly<Record<string, readonly string[]>>;
}

/** The least and the most of each number. */
export const pollLimits = {
  interval: [0, 86_400_000],
  unit: [1, 255],
  registers: [1, mostRead.registers],
  bits: [1, mostRead.bits],
  gap: [0, mostRead.bits],
} as const;

/** What the chart can show, in seconds. */
export const pollWindows = [60, 600, 3600, 0] as const;
export type PollWindow = (typeof pollWindows)[number];

export const defaultPoll: PollSettings = {
  from: 'frame',
  interval: 1000,
  unit: 1,
  registers: mostRead.registers,
  bits: mostRead.bits,
  gap: DEFAULT_GAP,
  window: 60,
  lines: {},
};

/** Reads stored settings; those that are not legal become the default. */
export const readPollSettings = record<PollSettings>(
  {
    from: oneOf(['frame', 'device']),
    interval: whole(...pollLimits.interval),
    unit: whole(...pollLimits.unit),
    registers: whole(...pollLimits.registers),
    bits: whole(...pollLimits.bits),
    gap: whole(...pollLimits.gap),
    window: oneOf<number>(pollWindows),
    lines: byName(listOf(text())),
  },
  defaultPoll,
);

/** The lines of a profile that are read. */
export const linesFor = ({ lines }: PollSettings, profile: string): readonly string[] =>
  (Object.hasOwn(lines, profile) && lines[profile]) || [];
