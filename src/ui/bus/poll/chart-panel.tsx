import { useComputed } from '@preact/signals';
import { chartData } from '../../../workbench/index.ts';
import { optionsOf, Select } from '../../kit/choice.tsx';
import { Fold } from '../../kit/fold.tsx';
import { useWords } from '../../parts/words.ts';
import { poll } from '../jobs.ts';
import { Chart, type Line } from './chart.tsx';
import '../../kit/table.css';

/** Rounds that the table behind the chart has. */
const ROUNDS = 20;

/** Colours and strokes by the order of the values drawn: no two have the same stroke and colour. */
const STROKES = [
  { colour: '--accent', dash: [] },
  { colour: '--value', dash: [8, 4] },
  { colour: '--good', dash: [2, 3] },
  { colour: '--check', dash: [12, 3, 2, 3] },
  { colour: '--function', dash: [5, 5] },
  { colour: '--bad', dash: [14, 6] },
  { colour: '--count', dash: [2, 6] },
  { colour: '--unit', dash: [9, 3, 3, 3] },
] as const;

/** The lines of the values that are drawn: the same list until others are. */
function linesDrawn(): readonly Line[] {
  const values = poll.source.value?.values ?? [];
  return poll.drawn.value.flatMap((index, at) => {
    const value = values[index];
    const stroke = STROKES[at % STROKES.length];
    return value && stroke ? [{ index, name: value.name, register: value.register, ...stroke }] : [];
  });
}

/** The chart with its legend, and the last rounds as a table. */
export function ChartPanel() {
  const words = useWords('poll');
  const lines = useComputed(linesDrawn).value;
  const window = useComputed(() => poll.settings.value.window).value;
  const shown = useComputed(() => {
    const { value: polled } = poll.polled;
    const { window } = poll.settings.value;
    if (polled === undefined) return { data: [[]] as [number[]], end: 0, window };
    const { samples } = polled;
    const end = samples.length > 0 ? samples.timeOf(samples.length - 1) : 0;
    const since = window === 0 ? Number.NEGATIVE_INFINITY : end - window * 1000;
    return { data: chartData(samples, polled.drawn, since), end: end / 1000, window };
  });
  return (
    <section class="poll-chart" aria-label={words.chart}>
      <div class="tools in-row">
        <h4>{words.chart}</h4>
        <label>
          {words.window}{' '}
          <Select
            value={String(window)}
            options={optionsOf(words.windows)}
            onChoose={(seconds) => {
              poll.settings.value = { ...poll.settings.value, window: Number(seconds) };
            }}
          />
        </label>
      </div>
      {lines.length === 0 ? <p class="said">{words.noChart}</p> : <Chart lines={lines} shown={shown} />}
      <Fold summary={words.asTable}>{() => <Rounds lines={lines} />}</Fold>
    </section>
  );
}

/** The last rounds, the newest first. */
function Rounds({ lines }: { readonly lines: readonly Line[] }) {
  const words = useWords('poll');
  const samples = poll.polled.value?.samples;
  if (samples === undefined) return null;
  const count = Math.min(ROUNDS, samples.length);
  return (
    <div class="poll-table table cards tiles">
      <table>
        <thead>
          <tr>
            <th scope="col">{words.columns.time}</th>
            {lines.map(({ index, name }) => (
              <th key={index} scope="col">
                {name}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {Array.from({ length: count }, (_, at) => samples.length - 1 - at).map((round) => (
            <tr key={samples.rounds - samples.length + round}>
              <th scope="row">{timeText(samples.timeOf(round))}</th>
              {lines.map(({ index, name, register }) => {
                const value = samples.valueOf(index, round);
                return (
                  <td key={index} data-column={name}>
                    {typeof value === 'number' || typeof value === 'bigint'
                      ? words.inUnit(value, register)
                      : words.missing}
                  </td>
                );
              })}
            </tr>
          ))}
        </tbody>
      </table>
    </div>
  );
}

const timeText = (time: number): string => {
  const date = new Date(time);
  const two = (number: number) => String(number).padStart(2, '0');
  const clock = [date.getHours(), date.getMinutes(), date.getSeconds()].map(two).join(':');
  return `${clock}.${Math.floor(date.getMilliseconds() / 100)}`;
};
