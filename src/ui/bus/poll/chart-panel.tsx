import { Component } from 'preact';
import { type ChartData, chartData } from '../../../workbench/index.ts';
import { optionsOf, Select } from '../../kit/choice.tsx';
import { Fold } from '../../kit/fold.tsx';
import { Chart, type Line } from './chart.tsx';
import type { ValuesProps } from './poll.ts';
import { pollWords as words } from './poll-words.ts';

/** Rounds that the table behind the chart has. */
const ROUNDS = 20;

/** Colours and strokes by the order of the values drawn: no two have the same stroke and colour. */
const COLOURS = ['--accent', '--value', '--good', '--check', '--function', '--bad', '--count', '--unit'] as const;
const DASHES: readonly (readonly number[])[] = [
  [],
  [8, 4],
  [2, 3],
  [12, 3, 2, 3],
  [5, 5],
  [14, 6],
  [2, 6],
  [9, 3, 3, 3],
];

/** The chart, what its lines are, and the same as a table. */
export class ChartPanel extends Component<ValuesProps> {
  private lines(): readonly Line[] {
    const { drawn, source } = this.props.polled;
    return drawn.flatMap((index, at) => {
      const value = source.values[index];
      const colour = COLOURS[at % COLOURS.length];
      const dash = DASHES[at % DASHES.length];
      return value && colour && dash ? [{ index, name: value.name, register: value.register, colour, dash }] : [];
    });
  }

  render() {
    const { polled, window, onWindow } = this.props;
    const { samples, drawn } = polled;
    const end = samples.length > 0 ? samples.timeOf(samples.length - 1) : 0;
    const since = window === 0 ? Number.NEGATIVE_INFINITY : end - window * 1000;
    const data = chartData(samples, drawn, since);
    const lines = this.lines();
    const names = lines.map(({ name }) => name);
    return (
      <section class="poll-chart" aria-label={words.chart}>
        <div class="tools">
          <h4>{words.chart}</h4>
          <label>
            {words.window}{' '}
            <Select
              value={String(window)}
              options={optionsOf(words.windows)}
              onChoose={(seconds) => onWindow(Number(seconds))}
            />
          </label>
        </div>
        {lines.length === 0 ? (
          <p class="said">{words.noChart}</p>
        ) : (
          <Chart
            key={drawn.join()}
            lines={lines}
            data={data}
            label={words.chartIs(names, spanOf(data))}
            end={end / 1000}
            window={window}
          />
        )}
        <Fold summary={words.asTable}>{() => this.table(lines)}</Fold>
      </section>
    );
  }

  /** What the chart shows, in the order of time, the newest first. */
  private table(lines: readonly Line[]) {
    const { samples } = this.props.polled;
    const count = Math.min(ROUNDS, samples.length);
    return (
      <div class="poll-table">
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
                    <td key={index} data-label={name}>
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
}

/** From the first to the last of the times, in milliseconds. */
const spanOf = ([times]: ChartData): number => 1000 * ((times.at(-1) ?? 0) - (times[0] ?? 0));

const timeText = (time: number): string => {
  const date = new Date(time);
  const two = (number: number) => String(number).padStart(2, '0');
  const clock = [date.getHours(), date.getMinutes(), date.getSeconds()].map(two).join(':');
  return `${clock}.${Math.floor(date.getMilliseconds() / 100)}`;
};
