import { characterBits, type LineCharacter, toHex, type WireBit } from '../../../../../modbus/index.ts';
import {
  bitRows,
  characterPath,
  pictureRows,
  character as printed,
  tracksEnd,
  trackTop,
  xOf,
} from '../../../../../workbench/index.ts';
import type { Drawing, PictureTexts } from './drawing.ts';

interface CharacterProps extends Drawing {
  readonly character: LineCharacter;
}

/** Pixels that a pair of digits, a bit's value, its letter and its name need. */
const PAIR = 15;
const BITS = 5;
const VALUE = 8;
const LETTER = 14;
const NAME = 38;

/** A character with its curve, as far as there is room its hexadecimal pair, and each bit's value and name. */
export function Character({ character, ...drawing }: CharacterProps) {
  const { scene, view, tracks } = drawing;
  const { frame, index, value, start, end } = character;
  const { serial, sent, own, fields } = scene;
  const x = xOf(view, start);
  const width = (end - start) * view.px;
  const top = pictureRows.hex - 12;
  const bottom = tracksEnd(tracks);
  const isOwn = frame === own;
  const ascii = sent[frame]?.reading.transport === 'ascii';
  return (
    <g
      class="character"
      data-kind={fields[frame]?.[index]?.kind}
      data-from={isOwn ? index : undefined}
      data-to={isOwn ? index + 1 : undefined}
    >
      <rect class="area" x={x} y={top} width={width} height={bottom - top} />
      {width >= PAIR && (
        <text class="pair" x={middleInSight(x, width, view.width)} y={pictureRows.hex}>
          {ascii ? characterText(value, width) : hexOf(value)}
        </text>
      )}
      {view.px >= BITS && <Bits {...drawing} start={start} bits={characterBits(value, serial)} />}
      <path class="edge" d={`M${x} ${top}V${bottom}`} />
      {tracks.map((track, at) => (
        <path
          key={track.key}
          class="wave"
          data-track={track.key}
          d={characterPath(view, character, serial, track, trackTop(at))}
        />
      ))}
    </g>
  );
}

/** The middle of what is in sight of a stretch: its name is seen whatever is scrolled away. */
const middleInSight = (x: number, width: number, sight: number) => (Math.max(x, 0) + Math.min(x + width, sight)) / 2;

/** A character of ASCII, with its code if there is room. */
const characterText = (value: number, width: number) =>
  width < 4 * PAIR ? printed(value) : `${printed(value)} (${hexOf(value)})`;

const hexOf = (value: number) => toHex(Uint8Array.of(value));

interface BitsProps extends Drawing {
  readonly start: number;
  readonly bits: readonly WireBit[];
}

function Bits({ start, bits, view, tracks, words }: BitsProps) {
  const { value, kind } = bitRows(tracks);
  const bottom = tracksEnd(tracks);
  const left = (index: number) => xOf(view, start + index);
  const middle = (index: number) => xOf(view, start + index + 0.5);
  return (
    <g class="bits">
      <path d={bits.map((_, index) => `M${left(index)} ${pictureRows.tracks - 3}V${bottom}`).join('')} />
      {view.px >= VALUE &&
        bits.map(({ level }, index) => (
          <text key={index} x={middle(index)} y={value}>
            {level}
          </text>
        ))}
      {view.px >= LETTER &&
        bits.map((bit, index) => (
          <text key={index} class="letter" x={middle(index)} y={kind}>
            {nameOf(bit, index, view.px < NAME ? words.bitLetters : words.bitNames)}
          </text>
        ))}
    </g>
  );
}

/** What a bit is: data bits by their number, the others by a name. */
const nameOf = ({ kind }: WireBit, index: number, names: PictureTexts['bitNames']) =>
  kind === 'data' ? index - 1 : names[kind];
