import { bitsPerCharacter, type ReceivedCharacter, type Receiver, toHex } from '../../../../modbus/index.ts';
import { bytesDuring, isInSight, pictureRows, type Scene, type StripView, xOf } from '../../../../workbench/index.ts';
import { wireWords as words } from '../wire-words.ts';

interface ReceivedProps {
  readonly scene: Scene;
  readonly view: StripView;
  readonly receiver: Receiver;
  readonly received: readonly ReceivedCharacter[];
  /** The y where the tracks end, and where this row begins. */
  readonly tracksEnd: number;
  readonly top: number;
}

/** Pixels that a pair, and a pair with its mark, need. */
const PAIR = 15;
/** Pixels a bit at which it is shown where the receiver looks. */
const LOOKS = 4;
const BOX = 20;
const WRONG = '✗';

/** What a receiver reads, below the bits it reads it from, with the places where it looks. */
export function Received({ scene, view, receiver, received, tracksEnd, top }: ReceivedProps) {
  const looks = bitsPerCharacter({ ...receiver.format, stopBits: 1 });
  return (
    <g>
      {received
        .filter(({ start, end }) => isInSight(view, start, end))
        .map(({ value, errors, start, end }) => {
          const x = xOf(view, start);
          const width = (end - start) * view.px;
          const bytes = bytesDuring(scene, start, end);
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
                      `M${xOf(view, start + (index + 0.5) * receiver.bit)} ${pictureRows.tracks - 4}V${tracksEnd}`,
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
