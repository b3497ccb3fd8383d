import { bitsTime, type SerialMode } from '../../modbus/index.ts';
import type { TimingWords } from '../../words/index.ts';
import { type SetLine, silenceReadings } from '../../workbench/index.ts';
import { words } from '../parts/page-words.ts';

interface SilenceProps {
  readonly line: SetLine | undefined;
  readonly mode: SerialMode;
  readonly text: TimingWords;
}

/** Character time and silences in each reading, and why there is more than one. */
export function SilencePanel({ line, mode, text }: SilenceProps) {
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
        <SilenceTable line={line} text={text} />
      )}
      {mode === 'ascii' ? (
        <p class="note">
          {text.asciiSilences} <span class="section">{words.section('SL 2.5.2.1')}</span>
        </p>
      ) : (
        <>
          <p class="note">
            {text.means} <span class="section">{words.section('SL 2.5.1.1')}</span>
          </p>
          <p class="note">
            {text.whyTwo}{' '}
            <span class="section">
              {words.section('SL 2.5.1')}, {words.section('SL 2.5.1.1')}
            </span>
          </p>
          <p class="note">
            {text.aboveFixed} <span class="section">{words.section('SL 2.5.1.1')}</span>
          </p>
        </>
      )}
    </section>
  );
}

function SilenceTable({ line, text }: { line: SetLine; text: TimingWords }) {
  const { baud } = line;
  return (
    <table class="silences" aria-labelledby="timing-silences">
      <thead>
        <tr>
          <th scope="col">{text.readings}</th>
          <th scope="col">{text.character}</th>
          <th scope="col">{text.t15}</th>
          <th scope="col">{text.t35}</th>
        </tr>
      </thead>
      <tbody>
        {silenceReadings(line).map(({ bits, character, t15, t35, inForce }) => (
          <tr key={bits ?? 0} data-in-force={inForce ? '' : undefined}>
            <th scope="row">
              {bits === undefined ? text.fixed : text.reading(bits)}{' '}
              {inForce && <small class="badge">{text.inForce}</small>}
            </th>
            <td data-column={text.character}>
              {character !== undefined && <Time time={character} baud={baud} text={text} />}
            </td>
            <td data-column={text.t15}>
              <Time time={t15} baud={baud} text={text} />
            </td>
            <td data-column={text.t35}>
              <Time time={t35} baud={baud} text={text} />
            </td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}

/** A time in the unit that suits it, in another, and in bits of the line. */
export function Time({ time, baud, text }: { time: number; baud: number; text: TimingWords }) {
  return (
    <>
      <span class="mono">{text.time(time)}</span>
      <small>
        {text.otherTime(time)}, {text.bits(time / bitsTime(baud, 1))}
      </small>
    </>
  );
}
