import type { HeardFrame } from '../../../bus/index.ts';
import { decodeFrame } from '../../../modbus/index.ts';
import { formatBytes } from '../../../notation/index.ts';
import { kindName } from '../../../workbench/index.ts';
import { useWords } from '../../parts/words.ts';
import { bus } from '../bus.ts';

/** Who heard each frame, who answered, and why the others did not: the last one in full, those before on request. */
export function HeardList() {
  const { heard: text, models } = useWords('virtual');
  const { summary } = useWords('page').page;
  const devices = bus.virtual.devices.value;
  const frames = bus.virtual.frames.value;
  const summaryOf = ({ bytes, transport }: HeardFrame) =>
    summary(decodeFrame(bytes, { transport, direction: 'request' }), bytes.length, transport);
  const nameOf = (wanted: number) => {
    const device = devices.find(({ id }) => id === wanted);
    return device === undefined ? '?' : kindName(device, models);
  };
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
                    <b>{text.device(nameOf(one.id), one.unit)}</b>: {text.by(one)}
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
        <button type="button" onClick={() => bus.virtual.forgetFrames()}>
          {text.clear}
        </button>
      )}
    </section>
  );
}
