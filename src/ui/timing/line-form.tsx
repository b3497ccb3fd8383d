import {
  bitsPerCharacter,
  bitsTime,
  type FormatStanding,
  formatStanding,
  RTU_CHARACTER_BITS,
  type Section,
  type SerialMode,
  serialFormatName,
  serialFormats,
} from '../../modbus/index.ts';
import type { TimingView } from '../../store/index.ts';
import { canCount, countedBy, timingFormat, USUAL_SPEEDS } from '../../workbench/index.ts';
import { Select } from '../kit/choice.tsx';
import { Field } from '../kit/field.tsx';
import { Segments } from '../kit/segments.tsx';
import { SectionNames } from '../parts/section-names.tsx';
import type { ViewProps } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import { EntryField } from './entry-field.tsx';

const SECTION: Readonly<Record<SerialMode, Section>> = { rtu: 'SL 2.5.1', ascii: 'SL 2.5.2' };
const SPEEDS = 'timing-speeds';
const STANDINGS: readonly FormatStanding[] = ['default', 'named', 'common', 'unusual', 'impossible'];

/** Mode, speed and format of the line. */
export function LineForm({ view }: ViewProps<TimingView>) {
  const text = useWords('timing');
  const { section } = useWords('page');
  const texts = view.shown.value;
  const { mode, line } = view.reading.value;
  return (
    <section class="panel" aria-labelledby="timing-line">
      <h2 id="timing-line">{text.line}</h2>
      <Segments
        label={text.mode}
        options={(['rtu', 'ascii'] as const).map((value) => ({ value, name: text.modes[value] }))}
        value={mode}
        onChoose={(chosen) => view.set('mode', chosen)}
      />
      <EntryField
        view={view}
        name="baud"
        label={text.speed}
        hint={line && `${text.speedHint(line.baud, bitsTime(line.baud, 1))} ${section('SL 3.2')}`}
        list={SPEEDS}
      />
      <datalist id={SPEEDS}>
        {USUAL_SPEEDS.map((speed) => (
          <option key={speed} value={speed} />
        ))}
      </datalist>
      <FormatChoice view={view} />
      {canCount(texts, mode) && (
        <Segments
          label={text.counted}
          options={[
            { value: 'format', name: text.countedBits(bitsPerCharacter(timingFormat(texts))) },
            { value: '11', name: text.countedBits(RTU_CHARACTER_BITS) },
          ]}
          value={countedBy(texts)}
          onChoose={(chosen) => view.set('counted', chosen)}
        />
      )}
    </section>
  );
}

/** All formats, by what the specification says of them in this mode. */
function FormatChoice({ view }: ViewProps<TimingView>) {
  const text = useWords('timing');
  const { mode } = view.reading.value;
  const chosen = timingFormat(view.shown.value);
  const standing = formatStanding(mode, chosen);
  const said = (
    <>
      {text.formatHint(mode, standing)} <SectionNames of={SECTION[mode]} />
    </>
  );
  const options = STANDINGS.flatMap((each) =>
    serialFormats
      .filter((format) => formatStanding(mode, format) === each)
      .map((format) => {
        const value = serialFormatName(format);
        return { value, name: text.formatOption(value, bitsPerCharacter(format)), group: text.standings[each] };
      }),
  );
  const wrong = standing === 'impossible';
  return (
    <Field id="timing-format" label={text.format} hint={said} error={wrong ? said : undefined}>
      <Select
        id="timing-format"
        class="mono"
        value={serialFormatName(chosen)}
        options={options}
        wrong={wrong}
        onChoose={(format) => view.set('format', format)}
      />
    </Field>
  );
}
