import { type Direction, type Span, serialFormatName, type WireBit } from '../../modbus/index.ts';
import { type Scene, sceneTime } from './scene.ts';

/** What a picture of a line is told with; times are microseconds. */
export interface PictureWords {
  frame(direction: Direction, size: number, length: string): string;
  time(micros: number): string;
  picture(frames: readonly string[], line: string): string;
}

/** A frame's direction, size and time. */
export function frameText(scene: Scene, index: number, words: PictureWords): string {
  const sent = scene.sent[index];
  const place = scene.line.frames[index];
  if (sent === undefined || place === undefined) return '';
  const length = sceneTime(scene, place.to) - sceneTime(scene, place.from);
  return words.frame(sent.reading.direction, sent.bytes.length, words.time(length));
}

/** What the picture shows, for those who do not see it; the table behind it has the bits. */
export function describeScene(scene: Scene, words: PictureWords): string {
  const { serial } = scene;
  return words.picture(
    scene.sent.map((_, index) => frameText(scene, index, words)),
    `${serial.baud} ${serialFormatName(serial)}`,
  );
}

/** What fields are called. */
export interface FieldNames {
  readonly labels: Readonly<Record<string, string>>;
  readonly short: Readonly<Record<string, string>>;
}

/** A field's name for places with little room. */
export const fieldShortName = ({ name }: Span, { labels, short }: FieldNames): string =>
  short[name] ?? (labels[name] ?? name).toLowerCase();

/** Bits as sent, in groups of one kind. */
export function bitsText(bits: readonly WireBit[]): string {
  let text = '';
  bits.forEach(({ kind, level }, index) => {
    if (index > 0 && bits[index - 1]?.kind !== kind) text += ' ';
    text += level;
  });
  return text;
}
