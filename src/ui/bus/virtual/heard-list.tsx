import type { DeviceSetup, HeardFrame } from '../../../bus/index.ts';
import { decodeFrame } from '../../../modbus/index.ts';
import { formatBytes } from '../../../notation/index.ts';
import { kindName } from '../../../workbench/index.ts';
import { words as pageWords } from '../../parts/page-words.ts';
import { virtual } from '../virtual-devices.ts';
import { virtualWords as words } from './virtual-words.ts';

interface HeardProps {
  readonly devices: readonly DeviceSetup[];
  /** The last first. */
  readonly frames: readonly HeardFrame[];
}

/** Who heard each frame, who answered, and why the others did not: the last one in full, those before on request. */
export function HeardList({ devices, frames }: HeardProps) {
  const text = words.heard;
  return (
    <section aria-labelledby="virtual-heard">
      <h3 id="virtual-heard">{text.heading}</h3>
      <p class="said">{frames.length === 0 ? text.none : text.intro}</p>
      <ol class="frames">
        {frames.map((frame, index) => (
          <li key={frame.number}>
            <details open={index === 0}>
              <summary>{summaryOf(frame)}</summary>
              <p class="mono bytes-line">{formatBytes(frame.bytes)}</p>
              {frame.by.length === 0 && <p class="said">{text.nobody}</p>}
              <ul class="by">
                {frame.by.map((one) => (
                  <li key={one.id} data-does={one.does}>
                    <b>{text.device(nameIn(devices, one.id), one.unit)}</b>: {text.by(one)}
                    {one.reply && one.reply.length > 0 && (
                      <span class="mono bytes-line"> {formatBytes(one.reply)}</span>
                    )}
                  </li>
                ))}
              </ul>
            </details>
          </li>
        ))}
      </ol>
      {frames.length > 0 && (
        <button type="button" onClick={() => virtual.forgetFrames()}>
          {text.clear}
        </button>
      )}
    </section>
  );
}

const nameIn = (devices: readonly DeviceSetup[], wanted: number): string => {
  const device = devices.find(({ id }) => id === wanted);
  return device === undefined ? '?' : kindName(device, words.models);
};

function summaryOf({ bytes, transport }: HeardFrame): string {
  return pageWords.page.summary(decodeFrame(bytes, { transport, direction: 'request' }), bytes.length, transport);
}
