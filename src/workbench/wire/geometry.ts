import {
  characterBits,
  demandWhole,
  firstAfter,
  type Line,
  type LineCharacter,
  type Quiet,
  type SerialFormat,
} from '../../modbus/index.ts';

/** The visible part of a line: the time it begins at, its width in pixels, and the pixels of a bit. */
export interface StripView {
  readonly from: number;
  readonly px: number;
  readonly width: number;
}

/** What is drawn of a line's voltage: the wire itself, or its opposite. */
export interface Track {
  readonly key: 'd1' | 'd0' | 'rs232' | 'ttl';
  /** Whether 1 is the lower of its two levels. */
  readonly inverted: boolean;
}

export type LevelKind = keyof typeof levelKinds;

/** Lines by their levels: RS-485 has two wires that mirror each other, RS-232 is upside down. */
export const levelKinds = {
  rs485: [
    { key: 'd1', inverted: false },
    { key: 'd0', inverted: true },
  ],
  rs232: [{ key: 'rs232', inverted: true }],
  ttl: [{ key: 'ttl', inverted: false }],
} as const satisfies Record<string, readonly Track[]>;

/** Least pixels a bit at which bits are drawn; below that, fields are drawn as blocks. */
const LEAST_BIT = 1.2;
export const showsBits = ({ px }: StripView): boolean => px >= LEAST_BIT;

/** Rows from the top, in pixels. */
export const pictureRows = { axis: 14, frame: 29, field: 46, hex: 63, tracks: 74 } as const;
export const TRACK_HEIGHT = 34;
const TRACK_GAP = 12;
const BIT_ROW = 14;
const RECEIVED = 40;

export const trackTop = (index: number): number => pictureRows.tracks + index * (TRACK_HEIGHT + TRACK_GAP);
/** Where the pictureRows below the tracks begin. */
export const tracksEnd = (tracks: readonly Track[]): number => trackTop(tracks.length) - TRACK_GAP + 4;
export const bitRows = (tracks: readonly Track[]) => {
  const end = tracksEnd(tracks);
  return { value: end + 11, kind: end + 11 + BIT_ROW, received: end + 2 * BIT_ROW + 6 };
};
export const pictureHeight = (tracks: readonly Track[], received: boolean): number =>
  bitRows(tracks).received + (received ? RECEIVED : 2);

/** A length with the digits that matter on paper. */
const round = (value: number) => Math.round(value * 100) / 100;

/** Where a time is, in pixels from the left. */
export const xOf = (view: StripView, time: number): number => round((time - view.from) * view.px);

export const isInSight = (view: StripView, from: number, to: number): boolean =>
  to > view.from && from < view.from + view.width / view.px;

/** The y of a level in a track whose upper edge is `top`. */
const yOf = (level: number, { inverted }: Track, top: number) =>
  (level === 1) === inverted ? top + TRACK_HEIGHT : top;

/** A character's curve in a track: from the idle level before it to the end of its stop bit. */
export function characterPath(
  view: StripView,
  { value, start, end }: LineCharacter,
  format: SerialFormat,
  track: Track,
  top: number,
): string {
  let path = `M${xOf(view, start)} ${yOf(1, track, top)}`;
  let level = 1;
  characterBits(value, format).forEach((bit, index) => {
    if (bit.level === level) return;
    if (index > 0) path += `H${xOf(view, start + index)}`;
    path += `V${yOf(bit.level, track, top)}`;
    level = bit.level;
  });
  return `${path}H${xOf(view, end)}`;
}

/** The idle line's curve, as far as it is in sight. */
export function quietPath(
  view: StripView,
  { from, to }: Pick<Quiet, 'from' | 'to'>,
  track: Track,
  top: number,
): string {
  const last = view.from + view.width / view.px;
  return `M${xOf(view, Math.max(from, view.from - 1))} ${yOf(1, track, top)}H${xOf(view, Math.min(to, last + 1))}`;
}

/** The characters in sight, found without looking at the others. */
export function charactersInSight({ characters }: Line, view: StripView): readonly LineCharacter[] {
  const first = firstAfter(characters, view.from);
  const last = view.from + view.width / view.px;
  let end = first;
  while (end < characters.length && (characters[end] as LineCharacter).start < last) end++;
  return characters.slice(first, end);
}

/** The character nearest to a time. */
export function characterNear({ characters }: Line, time: number): LineCharacter | undefined {
  const at = firstAfter(characters, time);
  const [before, next] = [characters[at - 1], characters[at]];
  if (before === undefined || next === undefined) return before ?? next;
  return time - before.end < next.start - time ? before : next;
}

const STEPS = [1, 2, 5];

/** Round steps of a scale, at least `least` apart: 1, 2, 5, 10, … */
export function roundStep(least: number): number {
  const power = 10 ** Math.floor(Math.log10(least));
  return (STEPS.find((step) => step * power >= least * 0.999999) ?? 10) * power;
}

/** More ticks than any picture has room for. */
const MOST_TICKS = 10_000;

/** The round times in sight, in the unit of `from`, `to` and `step`. Throws a `RangeError` for more than 10,000. */
export function ticksBetween(from: number, to: number, step: number): number[] {
  const first = Math.ceil(from / step);
  const count = Math.max(0, Math.floor(to / step) - first + 1);
  demandWhole('ticks', count, 0, MOST_TICKS);
  return Array.from({ length: count }, (_, index) => (first + index) * step);
}
