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
import type { TimingWords } from '../../words/index.ts';
import {
  baudEntry,
  canCount,
  countedBy,
  knownOf,
  type TimingName,
  type TimingTexts,
  timingFormat,
  USUAL_SPEEDS,
} from '../../workbench/index.ts';
import { Field, saidId } from '../kit/field.tsx';
import { Segments } from '../kit/segments.tsx';
import { idOf } from '../parts/labelled.tsx';
import { words } from '../parts/page-words.ts';
import { EntryField } from './entry-field.tsx';

export interface FormProps {
  readonly texts: TimingTexts;
  readonly mode: SerialMode;
  readonly text: TimingWords;
  readonly set: (name: TimingName, value: string) => void;
}

const SECTION: Readonly<Record<SerialMode, Section>> = { rtu: 'SL 2.5.1', ascii: 'SL 2.5.2' };
const SPEEDS = 'timing-speeds';
const STANDINGS: readonly FormatStanding[] = ['default', 'named', 'common', 'unusual', 'impossible'];

/** Mode, speed and format of the line. */
export function LineForm({ texts, mode, text, set }: FormProps) {
  const baud = baudEntry(texts);
  const value = knownOf(baud);
  const bits = bitsPerCharacter(timingFormat(texts));
  return (
    <>
      <Segments
        label={text.mode}
        options={(['rtu', 'ascii'] as const).map((each) => ({ value: each, name: text.modes[each] }))}
        value={mode}
        onChoose={(chosen) => set('mode', chosen)}
      />
      <EntryField
        name="baud"
        label={text.speed}
        text={texts.baud}
        entry={baud}
        hint={
          value === undefined ? undefined : `${text.speedHint(value, bitsTime(value, 1))} ${words.section('SL 3.2')}`
        }
        list={SPEEDS}
        onText={set}
      />
      <datalist id={SPEEDS}>
        {USUAL_SPEEDS.map((speed) => (
          <option key={speed} value={speed} />
        ))}
      </datalist>
      <FormatChoice texts={texts} mode={mode} text={text} set={set} />
      {canCount(texts, mode) && (
        <Segments
          label={text.counted}
          options={[
            { value: 'format', name: text.countedBits(bits) },
            { value: '11', name: text.countedBits(RTU_CHARACTER_BITS) },
          ]}
          value={countedBy(texts)}
          onChoose={(chosen) => set('counted', chosen)}
        />
      )}
    </>
  );
}

/** All formats, by what the specification says of them in this mode. */
function FormatChoice({ texts, mode, text, set }: FormProps) {
  const chosen = timingFormat(texts);
  const standing = formatStanding(mode, chosen);
  const impossible = standing === 'impossible';
  const said = (
    <>
      {text.formatHint(mode, standing)} <span class="section">{words.section(SECTION[mode])}</span>
    </>
  );
  const id = idOf('timing-format');
  return (
    <Field id={id} label={text.format} hint={said} error={impossible ? said : undefined}>
      <select
        id={id}
        class="mono"
        value={serialFormatName(chosen)}
        aria-invalid={impossible}
        aria-describedby={saidId(id)}
        onChange={({ currentTarget }) => set('format', currentTarget.value)}
      >
        {STANDINGS.map((each) => (
          <optgroup key={each} label={text.standings[each]}>
            {serialFormats
              .filter((format) => formatStanding(mode, format) === each)
              .map((format) => (
                <option key={serialFormatName(format)} value={serialFormatName(format)}>
                  {text.formatOption(serialFormatName(format), bitsPerCharacter(format))}
                </option>
              ))}
          </optgroup>
        ))}
      </select>
    </Field>
  );
}
