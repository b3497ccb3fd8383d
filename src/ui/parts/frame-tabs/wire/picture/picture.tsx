import { type ReceivedCharacter, type Receiver, serialFormatName } from '../../../../../modbus/index.ts';
import {
  bitRows,
  charactersInSight,
  describeScene,
  isInSight,
  type LevelKind,
  levelKinds,
  pictureHeight,
  pictureRows,
  quietPath,
  roundStep,
  type Scene,
  type StripView,
  sceneOrigin,
  sceneTime,
  showsBits,
  TRACK_HEIGHT,
  type Track,
  ticksBetween,
  tracksEnd,
  trackTop,
  xOf,
} from '../../../../../workbench/index.ts';
import { Character } from './character.tsx';
import type { Drawing, PictureTexts } from './drawing.ts';
import { FieldNames, Silences } from './marks.tsx';
import { Received } from './received-row.tsx';

export interface PictureProps {
  readonly scene: Scene;
  readonly kind: LevelKind;
  /** What is in sight, right of the names. */
  readonly view: StripView;
  readonly receiver?: Receiver | undefined;
  readonly received?: readonly ReceivedCharacter[] | undefined;
  readonly words: PictureTexts;
}

/** Pixels for the names at the left. */
export const GUTTER = 56;
const NAMES = 2;

/** The part of a line that is in sight, to scale, as one SVG. It is a function of its properties alone. */
export function Picture({ scene, kind, view, receiver, received, words }: PictureProps) {
  const tracks: readonly Track[] = levelKinds[kind];
  const drawing: Drawing = { scene, view, tracks, words };
  const height = pictureHeight(tracks, received !== undefined && showsBits(view));
  const width = view.width + GUTTER;
  return (
    <svg
      xmlns="http://www.w3.org/2000/svg"
      class="waveform"
      role="img"
      aria-label={describeScene(scene, words)}
      width={width}
      height={height}
      viewBox={`0 0 ${width} ${height}`}
    >
      <svg aria-hidden="true" x={GUTTER} width={view.width} height={height}>
        <Axis {...drawing} />
        <Silences {...drawing} />
        {scene.line.quiets
          .filter(({ from, to }) => isInSight(view, from, to))
          .map((quiet) =>
            tracks.map((track, index) => (
              <path
                key={`${quiet.from} ${track.key}`}
                class="wave"
                data-track={track.key}
                d={quietPath(view, quiet, track, trackTop(index))}
              />
            )),
          )}
        {showsBits(view) &&
          charactersInSight(scene.line, view).map((character) => (
            <Character key={`${character.frame} ${character.index}`} {...drawing} character={character} />
          ))}
        <FieldNames {...drawing} />
        {received && receiver && showsBits(view) && <Received {...drawing} receiver={receiver} received={received} />}
      </svg>
      <Names {...drawing} />
      {received && showsBits(view) && (
        <text class="name" x={NAMES} y={bitRows(tracks).received + 26}>
          {words.readRow}
        </text>
      )}
    </svg>
  );
}

/** Pixels between two marks of the scale. */
const MARKS_APART = 84;

function Axis({ scene, view, tracks, words }: Drawing) {
  const origin = sceneOrigin(scene);
  const last = view.from + view.width / view.px;
  const bit = sceneTime(scene, origin + 1);
  const step = roundStep((MARKS_APART / view.px) * bit);
  return (
    <g class="axis">
      {ticksBetween(sceneTime(scene, view.from), sceneTime(scene, last), step).map((time) => {
        const x = xOf(view, origin + time / bit);
        return (
          <g key={time}>
            <path d={`M${x} ${pictureRows.axis + 3}V${tracksEnd(tracks)}`} />
            <text x={x + 3} y={pictureRows.axis - 3}>
              {words.mark(time, step)}
            </text>
          </g>
        );
      })}
    </g>
  );
}

function Names({ tracks, scene: { serial }, words }: Drawing) {
  return (
    <g class="names">
      <text class="name" x={NAMES} y={pictureRows.axis - 3}>
        {words.timeRow}
      </text>
      <text x={NAMES} y={pictureRows.frame + 3}>
        {serial.baud}
      </text>
      <text x={NAMES} y={pictureRows.field}>
        {serialFormatName(serial)}
      </text>
      {tracks.map(({ key }, index) => {
        const { name, high, low } = words.tracks[key];
        const top = trackTop(index);
        return (
          <g key={key}>
            <text class="name" x={NAMES} y={top + TRACK_HEIGHT / 2 + 4}>
              {name}
            </text>
            <text class="level" x={GUTTER - 4} y={top + 5}>
              {high}
            </text>
            <text class="level" x={GUTTER - 4} y={top + TRACK_HEIGHT + 4}>
              {low}
            </text>
          </g>
        );
      })}
    </g>
  );
}
