import { bitsTime } from '../../modbus/index.ts';
import type { TimingView } from '../../store/index.ts';
import { type SetLine, silenceReadings } from '../../workbench/index.ts';
import { SectionNames } from '../parts/section-names.tsx';
import type { ViewProps } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';

/** Character time and silences in each reading, and why there is more than one. */
export function SilencePanel({ view }: ViewProps<TimingView>) {
  const text = useWords('timing');
  const { mode, line } = view.reading.value;
  return (
    <section class="panel" aria-labelledby="timing-silences">
      <h2 id="timing-silences">{text.silences}</h2>
      {line === undefined ? (
        <p>{text.correct}</p>
      ) : mode === 'ascii' ? (
        <p class="result">
          <b>
            {text.character} {text.time(bitsTime(line.baud, line.bits))}
          </b>{' '}
          <small>
            {text.otherTime(bitsTime(line.baud, line.bits))}, {text.bits(line.bits)}
          </small>
        </p>
      ) : (
        <SilenceTable line={line} />
      )}
      {mode === 'ascii' ? (
        <p class="note">
          {text.asciiSilences} <SectionNames of="SL 2.5.2.1" />
        </p>
      ) : (
        <>
          <p class="note">
            {text.means} <SectionNames of="SL 2.5.1.1" />
          </p>
          <p class="note">
            {text.whyTwo} <SectionNames of={['SL 2.5.1', 'SL 2.5.1.1']} />
          </p>
          <p class="note">
            {text.aboveFixed} <SectionNames of="SL 2.5.1.1" />
          </p>
        </>
      )}
    </section>
  );
}

function SilenceTable({ line }: { readonly line: SetLine }) {
  const text = useWords('timing');
  const { baud } = line;
  return (
    <table class="silences" aria-labelledby="timing-silences">
      <thead>
        <tr>
          {[text.readings, text.character, text.t15, text.t35].map((name) => (
            <th key={name} scope="col">
              {name}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {silenceReadings(line).map(({ bits, character, t15, t35, inForce }) => (
          <tr key={bits ?? 0} data-in-force={inForce ? '' : undefined}>
            <th scope="row">
              {bits === undefined ? text.fixed : text.reading(bits)}{' '}
              {inForce && <small class="badge">{text.inForce}</small>}
            </th>
            <td data-column={text.character}>{character !== undefined && <Time time={character} baud={baud} />}</td>
            <td data-column={text.t15}>
              <Time time={t15} baud={baud} />
            </td>
            <td data-column={text.t35}>
              <Time time={t35} baud={baud} />
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** A time in the unit that suits it, in another, and in bits of the line. */
export function Time({ time, baud }: { readonly time: number; readonly baud: number }) {
  const text = useWords('timing');
  return (
    <>
      <span class="mono">{text.time(time)}</span>
      <small>
        {text.otherTime(time)}, {text.bits(time / bitsTime(baud, 1))}
      </small>
    </>
  );
}
