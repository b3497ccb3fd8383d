import { type Span, serialFormatName } from '../../../modbus/index.ts';
import { words as pageWords } from '../../language.ts';
import { type Scene, timeOf } from '../exchange.ts';
import { wireWords as words } from '../language.ts';

/** A frame's direction, size and time. */
export function frameText(scene: Scene, index: number): string {
  const sent = scene.sent[index];
  const place = scene.line.frames[index];
  if (sent === undefined || place === undefined) return '';
  const length = timeOf(scene, place.to) - timeOf(scene, place.from);
  return words.frame(sent.reading.direction, sent.bytes.length, words.time(length));
}

/** What the picture shows, for those who do not see it; the table behind it has the bits. */
export function describeScene(scene: Scene): string {
  const { serial } = scene;
  return words.picture(
    scene.sent.map((_, index) => frameText(scene, index)),
    `${serial.baud} ${serialFormatName(serial)}`,
  );
}

/** A field's name where there is little room. */
export const shortName = ({ name }: Span): string =>
  pageWords.short[name] ?? (pageWords.labels[name] ?? name).toLowerCase();
