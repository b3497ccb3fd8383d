import type { HeardNews } from '../../../bus/index.ts';
import { disabledFor } from '../../kit/disabled-for.ts';
import { useWords } from '../../parts/words.ts';
import { bus } from '../bus.ts';
import { listening } from '../jobs.ts';
import '../../kit/table.css';

const COLUMNS = ['requests', 'replies', 'exceptions', 'unanswered', 'wrong'] as const;
const TROUBLES: ReadonlySet<string> = new Set(['exceptions', 'unanswered', 'wrong']);

/** Hears what others send: counts here, and every frame in the log. */
export function ListenPanel() {
  const words = useWords('listen');
  const running = listening.running.value;
  const end = listening.end.value;
  const heard = listening.heard.value;
  const connected = bus.connected.value;
  const ended = end?.kind === 'refused' ? words.refused(end.why) : end && words.ended[end.kind];
  return (
    <div class="listen">
      <p>{words.intro}</p>
      <div class="actions">
        {running ? (
          <button key="stop" type="button" class="stop" onClick={listening.stop}>
            {words.stop}
          </button>
        ) : (
          <button
            key="start"
            type="button"
            class={connected ? 'first' : undefined}
            {...disabledFor(connected ? undefined : words.notConnected)}
            onClick={() => listening.start()}
          >
            {words.start}
          </button>
        )}
        {!connected && !running && <span class="said">{words.notConnected}</span>}
      </div>
      <p class="verdict" role="status" data-severity={end && end.kind !== 'stopped' ? 'error' : undefined}>
        {(running || ended) && <strong>{ended ?? words.running}</strong>}
      </p>
      {heard && <Counts heard={heard} />}
    </div>
  );
}

/** What was heard, by unit and function. */
function Counts({ heard: { counts, frames, noise } }: { readonly heard: HeardNews }) {
  const words = useWords('listen');
  if (frames === 0 && noise === 0) return <p class="said">{words.nothing}</p>;
  const noisy = noise > 16 && noise > 4 * frames;
  return (
    <>
      <p>
        {words.heard(frames, noise)} {noisy && <span class="error">{words.noisy}</span>}
      </p>
      {counts.length > 0 && (
        <section aria-label={words.counts}>
          <div class="table cards">
            <table>
              <thead>
                <tr>
                  <th scope="col">{words.columns.unit}</th>
                  <th scope="col">{words.columns.functionCode}</th>
                  {COLUMNS.map((name) => (
                    <th key={name} scope="col" class="number">
                      {words.columns[name]}
                    </th>
                  ))}
                </tr>
              </thead>
              <tbody>
                {counts.map((count) => (
                  <tr key={`${count.unit} ${count.functionCode}`}>
                    <td>{words.unit(count.unit)}</td>
                    <td>{words.functionName(count.functionCode)}</td>
                    {COLUMNS.map((name) => (
                      <td
                        key={name}
                        class={count[name] > 0 && TROUBLES.has(name) ? 'number error' : 'number'}
                        data-column={words.columns[name]}
                      >
                        {count[name]}
                      </td>
                    ))}
                  </tr>
                ))}
              </tbody>
            </table>
          </div>
        </section>
      )}
    </>
  );
}
