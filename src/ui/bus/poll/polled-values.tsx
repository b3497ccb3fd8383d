import { useComputed } from '@preact/signals';
import { useState } from 'preact/hooks';
import { isNumber, samplesAsCsv } from '../../../workbench/index.ts';
import { disabledFor } from '../../kit/disabled-for.ts';
import { download, timedName } from '../../kit/download.ts';
import { SearchBox } from '../../kit/search-box.tsx';
import { part, Slot } from '../../parts/slot.tsx';
import { useWords } from '../../parts/words.ts';
import { bus } from '../bus.ts';
import { poll } from '../jobs.ts';
import { ValueTable } from './value-table.tsx';

/** Most values in the table at once; a search finds the others. */
const SHOWN = 100;

const chart = part(
  ['poll'],
  () => import('./chart-panel.tsx'),
  ({ ChartPanel }) => ChartPanel,
);

const timeCell = (time: number) => new Date(time).toISOString();

/** The values that were read, one in a line, and their chart. */
export function Values() {
  const words = useWords('poll');
  const [search, setSearch] = useState('');
  const source = poll.source.value;
  const isEmpty = useComputed(() => poll.polled.value?.samples.length === 0).value;
  if (source === undefined) return null;
  const wanted = search.trim().toLowerCase();
  const found = source.values.flatMap((value, index) =>
    `${value.name}\n${value.place}`.toLowerCase().includes(wanted) ? [{ value, index }] : [],
  );
  const save = () => {
    const { value: polled } = poll.polled;
    if (polled === undefined) return;
    const text = samplesAsCsv(polled.samples, source.values, { timeColumn: words.timeColumn, timeCell });
    download(text, timedName('poll', 'csv'), 'text/csv');
  };
  return (
    <section aria-label={words.values(source.title)}>
      <h3>{words.values(source.title)}</h3>
      <Progress />
      {source.values.length > SHOWN && (
        <SearchBox id="poll-find" label={words.find} bare hint={words.find} text={search} onText={setSearch} />
      )}
      <ValueTable shown={found.slice(0, SHOWN)} />
      {found.length > SHOWN && <p class="said">{words.moreValues(found.length - SHOWN)}</p>}
      {source.values.some(isNumber) && <Slot part={chart} with={{}} />}
      <div class="tools in-row">
        <button type="button" {...disabledFor(isEmpty ? words.nothingRead : undefined)} onClick={save}>
          {words.save}
        </button>
        <span class="said">{words.keeps(poll.polled.peek()?.samples.most ?? 0)}</span>
      </div>
    </section>
  );
}

/** How much was read, and how many requests failed. */
function Progress() {
  const words = useWords('poll');
  const { value: polled } = poll.polled;
  if (polled === undefined) return null;
  const { samples, requests, failed, doubtful, reasons, slow } = polled;
  return (
    <>
      <p class="poll-progress">{words.progress(samples.rounds, requests, failed, doubtful, reasons)}</p>
      {slow !== undefined && (
        <p class="verdict" data-severity="warning" role="status">
          {words.slow(slow, bus.rules.value.timeout)}
        </p>
      )}
    </>
  );
}
