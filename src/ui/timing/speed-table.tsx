import { useComputed } from '@preact/signals';
import { hasFixedSilences } from '../../modbus/index.ts';
import { type TableFormat, tableFormats } from '../../notation/index.ts';
import type { TimingView } from '../../store/index.ts';
import { KeptChoice } from '../../store/index.ts';
import type { WordsOf } from '../../words/index.ts';
import { bitsGroups, oneOf, speedTableText, timesAtSpeed, timingFormat, USUAL_SPEEDS } from '../../workbench/index.ts';
import { CopyAs } from '../kit/table.tsx';
import { storage } from '../parts/store.ts';
import type { ViewProps } from '../parts/use-view.ts';
import { useWords } from '../parts/words.ts';
import '../kit/table.css';

/** The format copied last. */
const copyFormat = new KeptChoice<TableFormat>(storage, 'timing-copy', 'tsv', oneOf(tableFormats));

/** The times of usual speeds in the formats in use, to be copied. */
export function SpeedTable({ view }: ViewProps<TimingView>) {
  const text = useWords('timing');
  const format = useComputed(() => view.shown.value.format);
  const baud = useComputed(() => view.reading.value.line?.baud);
  const groups = useComputed(() => bitsGroups(timingFormat({ format: format.value }))).value;
  return (
    <section class="panel" aria-labelledby="timing-usual">
      <h2 id="timing-usual">{text.speeds}</h2>
      <p class="note soft">{text.speedsIntroduction}</p>
      <div class="table cards many tiles">
        <div class="table cards many tiles">
          <table class="speeds" aria-labelledby="timing-usual">
            <thead>
              <tr>
                <th scope="col" rowSpan={2}>
                  {text.speedColumn}
                </th>
                {groups.map(({ bits, names }) => (
                  <th key={bits} scope="colgroup" colSpan={3}>
                    {text.formatsOfBits(bits, names)}
                  </th>
                ))}
              </tr>
              <tr>
                {groups.flatMap(({ bits }) =>
                  [text.character, text.t15, text.t35].map((name) => (
                    <th key={text.columnOf(name, bits)} scope="col">
                      {name}
                    </th>
                  )),
                )}
              </tr>
            </thead>
            <tbody>
              {USUAL_SPEEDS.map((speed) => (
                <tr key={speed} aria-current={speed === baud.value ? 'true' : undefined}>
                  <th scope="row" class="mono">
                    {speed}
                  </th>
                  {groups.flatMap(({ bits }) => cellsOf(speed, bits, text))}
                </tr>
              ))}
            </tbody>
          </table>
        </div>
      </div>
      <CopyAs
        label={text.copy}
        as={text.copyAs}
        formats={text.formats}
        format={copyFormat.value}
        onFormat={(chosen) => {
          copyFormat.value = chosen;
        }}
        text={(chosen) => speedTableText(groups, chosen, text)}
        copied={text.copied}
        refused={() => text.copyFailed}
      />
    </section>
  );
}

/** Character time and silences of a speed; where they are fixed, with what counting would give. */
function cellsOf(speed: number, bits: number, text: WordsOf<'timing'>) {
  const { character, t15, t35, counted } = timesAtSpeed(speed, bits);
  const fixed = hasFixedSilences(speed);
  const cells = [
    // Where columns are not side by side, the bits name the character, and the next cells belong to it.
    { name: text.bits(bits), time: character },
    { name: text.t15, time: t15, counted: counted.t15 },
    { name: text.t35, time: t35, counted: counted.t35 },
  ];
  return cells.map((cell) => (
    <td key={text.columnOf(cell.name, bits)} data-column={cell.name} class="mono">
      {fixed && cell.counted !== undefined ? (
        <>
          {cell.time} <small>({text.microseconds(cell.counted)})</small>
        </>
      ) : (
        text.microseconds(cell.time)
      )}
    </td>
  ));
}
