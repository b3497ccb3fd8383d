import { bitsPerCharacter, type ReceivedCharacter, type Receiver, toHex } from '../../../../../modbus/index.ts';
import { bitRows, bytesDuring, isInSight, pictureRows, tracksEnd, xOf } from '../../../../../workbench/index.ts';
import type { Drawing } from './drawing.ts';

interface ReceivedProps extends Drawing {
  readonly receiver: Receiver;
  readonly received: readonly ReceivedCharacter[];
}

/** Pixels that a pair, and a pair with its mark, need. */
const PAIR = 15;
/** Pixels a bit at which it is shown where the receiver looks. */
const LOOKS = 4;
const BOX = 20;
const WRONG = '✗';

/** What a receiver reads, below the bits it reads it from, with the places where it looks. */
export function Received({ scene, view, tracks, words, receiver, received }: ReceivedProps) {
  const end = tracksEnd(tracks);
  const top = bitRows(tracks).received;
  const looks = bitsPerCharacter({ ...receiver.format, stopBits: 1 });
  return (
    <g>
      {received
        .filter(({ start, end }) => isInSight(view, start, end))
        .map(({ value, errors, start, end: last }) => {
          const x = xOf(view, start);
          const width = (last - start) * view.px;
          const bytes = bytesDuring(scene, start, last);
          const pair = toHex(Uint8Array.of(value));
          return (
            <g
              key={start}
              class="received"
              data-error={errors.length > 0 ? '' : undefined}
              data-from={bytes?.[0]}
              data-to={bytes?.[1]}
            >
              {view.px * receiver.bit >= LOOKS && (
                <path
                  class="look"
                  d={Array.from(
                    { length: looks },
                    (_, index) =>
                      `M${xOf(view, start + (index + 0.5) * receiver.bit)} ${pictureRows.tracks - 4}V${end}`,
                  ).join('')}
                />
              )}
              <rect x={x} y={top + 8} width={width} height={BOX} />
              {width >= PAIR && (
                <text x={x + width / 2} y={top + 22}>
                  {errors.length > 0 && width >= 2 * PAIR ? `${pair} ${WRONG}` : pair}
                </text>
              )}
              <title>{[pair, ...errors.map((error) => words.errors[error])].join(', ')}</title>
            </g>
          );
        })}
    </g>
  );
}
