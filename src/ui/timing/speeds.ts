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

/** The times of a speed with characters of so many bits, in microseconds. */
export const timesAt = (baud: number, bits: number) => ({
  character: bitsTime(baud, bits),
  counted: countedSilences(baud, bits),
  ...rtuSilences(baud, bits),
});
