import { type Span, toHex } from '../../../../../modbus/index.ts';
import { fieldShortName } from '../../../../../workbench/index.ts';
import type { PictureTexts } from './drawing.ts';

interface PacketProps {
  readonly bytes: Uint8Array;
  readonly spans: readonly Span[];
  /** Bytes of the MBAP header; 0 for a bare PDU. */
  readonly header: number;
  readonly width: number;
  readonly words: PictureTexts;
}

/** Bytes in a line, with room and without. */
const LINE = 16;
const SHORT_LINE = 8;
const ROOM = 600;
/** The greatest width of a cell, and its height. */
const WIDEST = 62;
const CELL = 30;
const LINE_HEIGHT = 92;
const LETTER = 6.3;
const EDGE = 1;

interface Piece {
  readonly from: number;
  readonly to: number;
}

/** The bytes of a segment, each a box, under the names of their fields and of the two parts of the segment. */
export function Packet({ bytes, spans, header, width, words }: PacketProps) {
  const line = width < ROOM ? SHORT_LINE : LINE;
  const cell = Math.min(WIDEST, Math.floor((width - 2 * EDGE) / line));
  const lines = Array.from({ length: Math.ceil(bytes.length / line) }, (_, index) => index * line);
  const height = lines.length * LINE_HEIGHT;
  const place =
    (start: number) =>
    ({ from, to }: Piece) => {
      const first = Math.max(from, start);
      const end = Math.min(to, start + line);
      return end > first ? { x: EDGE + (first - start) * cell, width: (end - first) * cell } : undefined;
    };
  const split = Math.min(header, bytes.length);
  const parts = [
    { from: 0, to: split, name: words.packet.mbap(split) },
    { from: split, to: bytes.length, name: words.packet.pdu(bytes.length - split) },
  ];
  return (
    <svg
      xmlns="http://www.w3.org/2000/svg"
      class="waveform"
      role="img"
      aria-label={words.packet.picture(bytes.length)}
      width={width}
      height={height}
      viewBox={`0 0 ${width} ${height}`}
    >
      {lines.map((start, index) => (
        <g key={start} transform={`translate(0 ${index * LINE_HEIGHT})`}>
          {parts.map((part) => (
            <PartName key={part.name} name={part.name} place={place(start)(part)} />
          ))}
          {spans.map((span) => (
            <Field
              key={`${span.name} ${span.from}`}
              span={span}
              name={fieldShortName(span, words)}
              place={place(start)(span)}
            />
          ))}
          {Array.from(bytes.subarray(start, start + line), (value, at) => (
            <Cell key={at} index={start + at} value={value} x={EDGE + at * cell} width={cell} spans={spans} />
          ))}
        </g>
      ))}
    </svg>
  );
}

type Place = { readonly x: number; readonly width: number } | undefined;

function PartName({ name, place }: { name: string; place: Place }) {
  if (place === undefined) return null;
  const { x, width } = place;
  return (
    <g class="measure">
      <path d={`M${x + 1} 14v6M${x + 1} 17H${x + width - 1}M${x + width - 1} 14v6`} />
      {width > name.length * LETTER && (
        <text x={x + width / 2} y={12}>
          {name}
        </text>
      )}
    </g>
  );
}

function Field({ span, name, place }: { span: Span; name: string; place: Place }) {
  if (place === undefined) return null;
  const { x, width } = place;
  const room = Math.floor((width - 4) / LETTER);
  return (
    <g class="field-name" data-kind={span.kind} data-from={span.from} data-to={span.to}>
      <rect class="bar" x={x} y={24} width={width} height={16} />
      <text x={x + width / 2} y={36}>
        {name.length > room ? `${name.slice(0, Math.max(1, room - 1))}…` : name}
      </text>
      <title>{name}</title>
    </g>
  );
}

interface CellProps {
  readonly index: number;
  readonly value: number;
  readonly x: number;
  readonly width: number;
  readonly spans: readonly Span[];
}

function Cell({ index, value, x, width, spans }: CellProps) {
  const kind = spans.find(({ from, to }) => from <= index && index < to)?.kind;
  return (
    <g class="cell" data-kind={kind} data-from={index} data-to={index + 1}>
      <rect class="area" x={x} y={40} width={width} height={CELL} />
      <text class="pair" x={x + width / 2} y={60}>
        {toHex(Uint8Array.of(value))}
      </text>
      <text class="letter" x={x + width / 2} y={82}>
        {index}
      </text>
    </g>
  );
}
