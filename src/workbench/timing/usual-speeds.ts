import {
  bitsPerCharacter,
  bitsTime,
  countedSilences,
  formatStanding,
  rtuSilences,
  type SerialFormat,
  serialFormatName,
  serialFormats,
} from '../../modbus/index.ts';
import { type TableFormat, writeTableText } from '../../notation/index.ts';

/** Speeds that devices can be set to, in bits a second. */
export const USUAL_SPEEDS = [
  300, 600, 1200, 1800, 2400, 4800, 9600, 14_400, 19_200, 28_800, 38_400, 56_000, 57_600, 76_800, 115_200, 128_000,
  187_500, 230_400, 250_000, 256_000, 460_800, 500_000, 576_000, 921_600, 1_000_000, 2_000_000, 4_000_000,
] as const;

/** Formats whose characters have the same number of bits, and so the same times. */
export interface BitsGroup {
  readonly bits: number;
  readonly names: readonly string[];
}

const isKnown = (format: SerialFormat) =>
  (['rtu', 'ascii'] as const).some((mode) => ['default', 'named', 'common'].includes(formatStanding(mode, format)));

/** The groups of the formats in use, and of the one chosen, longest characters first. */
export function bitsGroups(chosen: SerialFormat): BitsGroup[] {
  const shown = serialFormats.filter(
    (format) => isKnown(format) || serialFormatName(format) === serialFormatName(chosen),
  );
  const sizes = [...new Set(shown.map(bitsPerCharacter))].toSorted((a, b) => b - a);
  return sizes.map((bits) => ({
    bits,
    names: shown.filter((format) => bitsPerCharacter(format) === bits).map(serialFormatName),
  }));
}

/** The times of a speed, in microseconds, by the bits of a character. */
export const timesAtSpeed = (baud: number, bits: number) => ({
  character: bitsTime(baud, bits),
  counted: countedSilences(baud, bits),
  ...rtuSilences(baud, bits),
});

/** What the table of usual speeds is told with. */
export interface SpeedTableWords {
  readonly speedColumn: string;
  readonly character: string;
  readonly t15: string;
  readonly t35: string;
  readonly counted15: string;
  readonly counted35: string;
  columnOf(what: string, bits: number): string;
  inMicroseconds(column: string): string;
  microseconds(value: number): string;
}

/** The table as text, in microseconds; what counting would give has columns of its own. */
export function speedTableText(groups: readonly BitsGroup[], format: TableFormat, words: SpeedTableWords): string {
  const head = groups.flatMap(({ bits }) =>
    [words.character, words.t15, words.t35, words.counted15, words.counted35].map((name) => words.columnOf(name, bits)),
  );
  const body = USUAL_SPEEDS.map((speed) => [
    String(speed),
    ...groups.flatMap(({ bits }) => {
      const { character, t15, t35, counted } = timesAtSpeed(speed, bits);
      return [character, t15, t35, counted.t15, counted.t35].map((time) => words.microseconds(time));
    }),
  ]);
  return writeTableText([[words.speedColumn, ...head.map((column) => words.inMicroseconds(column))], ...body], format);
}
