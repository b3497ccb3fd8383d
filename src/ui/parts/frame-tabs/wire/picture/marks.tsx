import type { Quiet, Span } from '../../../../../modbus/index.ts';
import {
  bitsIn,
  fieldShortName,
  frameText,
  isInSight,
  pictureRows,
  type Scene,
  sceneTime,
  showsBits,
  tracksEnd,
  xOf,
} from '../../../../../workbench/index.ts';
import type { Drawing } from './drawing.ts';

/** Pixels that a letter of a name takes, on average. */
const LETTER = 6.3;

interface MarkProps extends Pick<Drawing, 'view'> {
  readonly from: number;
  readonly to: number;
  readonly y: number;
  readonly text: string;
  readonly name: string;
}

/** A measure from one time to another, named in the middle of what is in sight of it. */
function Measure({ view, from, to, y, text, name }: MarkProps) {
  if (!isInSight(view, from, to)) return null;
  const left = Math.max(xOf(view, from), -8);
  const right = Math.min(xOf(view, to), view.width + 8);
  const seen = [Math.max(left, 0), Math.min(right, view.width)] as const;
  const [middle, half] = [(seen[0] + seen[1]) / 2, (text.length * LETTER) / 2 + 4];
  const fits = seen[1] - seen[0] > 2 * half - 4;
  // The line leaves room for its name.
  const across = fits
    ? `H${Math.max(left, middle - half)}M${Math.min(right, middle + half)} ${y}H${right}`
    : `H${right}`;
  return (
    <g class="measure" data-measure={name}>
      <path d={`M${left} ${y - 3}v6M${left} ${y}${across}M${right} ${y - 3}v6`} />
      {fits ? (
        <text x={middle} y={y + 3}>
          {text}
        </text>
      ) : (
        <title>{text}</title>
      )}
    </g>
  );
}

/** How long frames and silences take, and where the limits t1.5 and t3.5 are. */
export function Silences(drawing: Drawing) {
  const { scene, view, words } = drawing;
  const { line } = scene;
  return (
    <g>
      {line.frames.map(({ from, to }, index) => (
        <Measure
          key={from}
          view={view}
          from={from}
          to={to}
          y={pictureRows.frame}
          text={frameText(scene, index, words)}
          name="frame"
        />
      ))}
      {line.quiets
        .filter(({ from, to }) => isInSight(view, from, to))
        .map((quiet) => (
          <Silence key={quiet.from} {...drawing} quiet={quiet} />
        ))}
    </g>
  );
}

function Silence({ scene, view, tracks, words, quiet }: Drawing & { readonly quiet: Quiet }) {
  const end = tracksEnd(tracks);
  const { kind, from, to } = quiet;
  const { silences, serial } = scene;
  const whole = words.time(sceneTime(scene, to) - sceneTime(scene, from));
  const t15 = silences ? bitsIn(serial, silences.t15) : 0;
  const t35 = silences ? bitsIn(serial, silences.t35) : 0;
  const measures = [
    ...(kind === 'between' ? [{ from, to, y: pictureRows.frame, text: words.delayMark(whole), name: 'delay' }] : []),
    ...(kind === 'inside' ? [{ from, to, y: end + 14, text: words.gapMark(whole), name: 'gap' }] : []),
    ...(silences && kind === 'before'
      ? [{ from: to - t35, to, y: pictureRows.field, text: words.t35(words.time(silences.t35)), name: 't35' }]
      : []),
    ...(silences && kind !== 'before'
      ? [
          { from, to: from + t15, y: pictureRows.hex, text: words.t15(words.time(silences.t15)), name: 't15' },
          ...(kind === 'inside'
            ? []
            : [{ from, to: from + t35, y: pictureRows.field, text: words.t35(words.time(silences.t35)), name: 't35' }]),
        ]
      : []),
  ];
  const limit = (time: number, name: string) => (
    <path class="limit" data-limit={name} d={`M${xOf(view, time)} ${pictureRows.field}V${end}`} />
  );
  return (
    <g>
      {kind === 'inside' && (
        <rect
          class="gap"
          x={xOf(view, from)}
          y={pictureRows.tracks - 4}
          width={(to - from) * view.px}
          height={end - pictureRows.tracks + 4}
        />
      )}
      {measures.map((measure) => (
        <Measure key={measure.name} view={view} {...measure} />
      ))}
      {silences && kind === 'before' && limit(to - t35, 't35')}
      {silences && kind !== 'before' && limit(from + t15, 't15')}
      {silences && kind !== 'before' && from + t35 <= to && limit(from + t35, 't35')}
    </g>
  );
}

/** The fields over their bytes; where bits have no room, as blocks instead of them. */
export function FieldNames(drawing: Drawing) {
  return (
    <g>
      {drawing.scene.sent.map(({ reading }, frame) =>
        reading.spans.map((span) => (
          <FieldName key={`${frame} ${span.from} ${span.name}`} {...drawing} frame={frame} span={span} />
        )),
      )}
    </g>
  );
}

interface FieldProps extends Drawing {
  readonly frame: number;
  readonly span: Span;
}

function FieldName({ scene, view, tracks, words, frame, span }: FieldProps) {
  const place = placeOf(scene, frame, span);
  if (place === undefined || !isInSight(view, place.from, place.to)) return null;
  const left = Math.max(xOf(view, place.from), -2);
  const right = Math.min(xOf(view, place.to), view.width + 2);
  const width = Math.max(right - left, 0.5);
  const name = fieldShortName(span, words);
  /** Where the field ends if it is drawn as a block. */
  const end = showsBits(view) ? undefined : tracksEnd(tracks);
  const own = frame === scene.own;
  return (
    <g
      class="field-name"
      data-kind={span.kind}
      data-from={own ? span.from : undefined}
      data-to={own ? span.to : undefined}
    >
      <rect
        class="bar"
        x={left}
        y={pictureRows.field - 13}
        width={width}
        height={end === undefined ? 15 : end - pictureRows.field + 13}
      />
      {end !== undefined && <Block x={left} width={width} end={end} text={words.bytes(span.to - span.from)} />}
      {width > name.length * LETTER ? (
        <text x={(Math.max(left, 0) + Math.min(right, view.width)) / 2} y={pictureRows.field - 2}>
          {name}
        </text>
      ) : (
        <title>{name}</title>
      )}
    </g>
  );
}

interface BlockProps {
  readonly x: number;
  readonly width: number;
  readonly end: number;
  readonly text: string;
}

/** A field whose bits have no room. */
function Block({ x, width, end, text }: BlockProps) {
  return (
    <>
      <rect class="block" x={x} y={pictureRows.tracks - 3} width={width} height={end - pictureRows.tracks} />
      {width > text.length * LETTER && (
        <text x={x + width / 2} y={(pictureRows.tracks + end) / 2}>
          {text}
        </text>
      )}
    </>
  );
}

/** From a field's first start bit to its last stop bit. */
function placeOf({ line, sent }: Scene, frame: number, { from, to }: Span) {
  const before = frame === 0 ? 0 : (sent[0]?.bytes.length ?? 0);
  const [first, last] = [line.characters[before + from], line.characters[before + to - 1]];
  return to > from && first && last ? { from: first.start, to: last.end } : undefined;
}
