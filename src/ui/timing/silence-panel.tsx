import { bitsTime } from '../../modbus/index.ts';
import type { TimingView } from '../../store/index.ts';
import { type SetLine, silenceReadings } from '../../workbench/index.ts';
import { Table } from '../kit/table.tsx';
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
        <p class="note soft">
          {text.asciiSilences} <SectionNames of="SL 2.5.2.1" />
        </p>
      ) : (
        <>
          <p class="note soft">
            {text.means} <SectionNames of="SL 2.5.1.1" />
          </p>
          <p class="note soft">
            {text.whyTwo} <SectionNames of={['SL 2.5.1', 'SL 2.5.1.1']} />
          </p>
          <p class="note soft">
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
  const time = (value: number | undefined) => value !== undefined && <Time time={value} baud={baud} />;
  return (
    <Table
      class="silences"
      labelledBy="timing-silences"
      columns={[
        {
          name: text.readings,
          cell: ({ bits, inForce }) => (
            <>
              {bits === undefined ? text.fixed : text.reading(bits)}{' '}
              {inForce && <small class="badge">{text.inForce}</small>}
            </>
          ),
        },
        { name: text.character, cell: ({ character }) => time(character) },
        { name: text.t15, cell: ({ t15 }) => time(t15) },
        { name: text.t35, cell: ({ t35 }) => time(t35) },
      ]}
      rows={silenceReadings(line)}
      keyOf={({ bits }) => bits ?? 0}
      attributes={({ inForce }) => ({ 'data-in-force': inForce ? '' : undefined })}
      narrow="cards"
    />
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
