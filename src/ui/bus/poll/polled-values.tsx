import { Component } from 'preact';
import { isNumber, samplesAsCsv } from '../../../workbench/index.ts';
import { download } from '../../kit/download.ts';
import { Slot } from '../../parts/slot.tsx';
import { bus } from '../index.ts';
import type { ValuesProps } from './poll.ts';
import { pollWords as words } from './poll-words.ts';
import { ValueTable } from './value-table.tsx';

/** Most values in the table at once; a search finds the others. */
const SHOWN = 100;

const loadChart = () => import('./chart-panel.tsx').then(({ ChartPanel }) => ChartPanel);

const timeCell = (time: number) => new Date(time).toISOString();

/** What has been read: a line a value, and the chart. */
export class Values extends Component<ValuesProps, { readonly search: string }> {
  override state = { search: '' };

  private save() {
    const { samples, source } = this.props.polled;
    const time = new Date().toISOString().slice(0, 19).replaceAll(':', '');
    download(
      samplesAsCsv(samples, source.values, { timeColumn: words.timeColumn, timeCell }),
      `poll-${time}.csv`,
      'text/csv',
    );
  }

  render() {
    const { polled } = this.props;
    const { source, samples, requests, failed, doubtful, slow } = polled;
    const { search } = this.state;
    const wanted = search.trim().toLowerCase();
    const found = source.values.flatMap((value, index) =>
      `${value.name}\n${value.place}`.toLowerCase().includes(wanted) ? [index] : [],
    );
    return (
      <section aria-label={words.values(source.title)}>
        <h3>{words.values(source.title)}</h3>
        <p class="poll-progress">{words.progress(samples.rounds, requests, failed, doubtful)}</p>
        {slow !== undefined && (
          <p class="verdict" data-severity="warning" role="status">
            {words.slow(slow, bus.state.rules.timeout)}
          </p>
        )}
        {source.values.length > SHOWN && (
          <div class="tools">
            <input
              type="search"
              aria-label={words.find}
              placeholder={words.find}
              autocomplete="off"
              spellcheck={false}
              value={search}
              onInput={({ currentTarget }) => this.setState({ search: currentTarget.value })}
            />
          </div>
        )}
        <ValueTable polled={polled} shown={found.slice(0, SHOWN)} />
        {found.length > SHOWN && <p class="said">{words.moreValues(found.length - SHOWN)}</p>}
        {source.values.some(isNumber) && <Slot part={loadChart} with={this.props} />}
        <div class="tools">
          <button type="button" disabled={samples.length === 0} onClick={() => this.save()}>
            {words.save}
          </button>
          <span class="said">{words.keeps(samples.most)}</span>
        </div>
      </section>
    );
  }
}
