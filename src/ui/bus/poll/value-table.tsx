import { computed, type ReadonlySignal, useComputed, useSignal } from '@preact/signals';
import { useEffect, useMemo } from 'preact/hooks';
import { isBitTable } from '../../../devices/index.ts';
import { formatHex } from '../../../notation/index.ts';
import { isNumber, MOST_DRAWN, type Polled, type PolledValue } from '../../../workbench/index.ts';
import { disabledFor } from '../../kit/disabled-for.ts';
import { useWords } from '../../parts/words.ts';
import { poll } from '../jobs.ts';
import '../../kit/table.css';

/** Registers of a value that are shown in hexadecimal; a text may have a hundred. */
const HEX_SHOWN = 4;
/** Ages grow also while nothing is read. Milliseconds. */
const AGE_EACH = 1000;

/** The time of the window, counted as the samples are. */
const timeNow = () => performance.timeOrigin + performance.now();

interface ShownValue {
  readonly value: PolledValue;
  /** Its place among all. */
  readonly index: number;
}

/** Each value with its last reading and its statistics. */
export function ValueTable({ shown }: { readonly shown: readonly ShownValue[] }) {
  const { columns } = useWords('poll');
  const now = useSignal(timeNow());
  useEffect(() => {
    const timer = setInterval(() => {
      now.value = timeNow();
    }, AGE_EACH);
    return () => clearInterval(timer);
  }, [now]);
  const { name, place, last, hex, least, most, mean, errors, age } = columns;
  return (
    <div class="poll-table table cards tiles">
      <table>
        <thead>
          <tr>
            {[name, place, last, hex, least, most, mean, errors, age].map((column) => (
              <th key={column} scope="col">
                {column}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {shown.map(({ value, index }) => (
            <ValueRow key={index} index={index} value={value} now={now} />
          ))}
        </tbody>
      </table>
    </div>
  );
}

interface RowProps extends ShownValue {
  readonly now: ReadonlySignal<number>;
}

/** A value. Its cells change by themselves; the row is drawn again only when the value fails or is read again. */
function ValueRow({ index, value, now }: RowProps) {
  const words = useWords('poll');
  const { columns, missing } = words;
  const { place, register } = value;
  const isDoubtful = useComputed(() => poll.polled.value?.samples.statistics[index]?.isDoubtful).value;
  const failed = useComputed(() => {
    const failure = poll.polled.value?.failures[index];
    return failure && words.failed(failure);
  }).value;
  const statistics = (polled: Polled) => polled.samples.statistics[index];
  const number = (one: number | bigint | undefined) =>
    one === undefined || !isNumber(value)
      ? undefined
      : isBitTable(register.table)
        ? String(one)
        : words.inUnit(one, register);
  /** A text that follows the readings; a dash before the first. */
  const live = (text: (polled: Polled) => string | undefined) => (
    <Live text={() => (poll.polled.value && text(poll.polled.value)) ?? missing} />
  );
  return (
    <tr data-failed={failed ? '' : undefined} data-severity={isDoubtful ? 'warning' : undefined}>
      <th scope="row">{isNumber(value) ? <DrawBox index={index} name={value.name} /> : value.name}</th>
      <td class="mono" data-column={columns.place}>
        {place}
      </td>
      <td class="last" data-column={columns.last}>
        {live(({ samples: { last }, powers }) =>
          last[index] === undefined ? undefined : words.reading(last[index], register, powers[index]),
        )}{' '}
        {isDoubtful && <span class="doubtful">{words.doubtful}</span>}
        {failed && <span class="error">{failed}</span>}
      </td>
      <td class="mono" data-column={columns.hex}>
        {live(({ items }) => (isBitTable(register.table) ? undefined : hexOf(items[index])))}
      </td>
      <td data-column={columns.least}>{live((polled) => number(statistics(polled)?.least))}</td>
      <td data-column={columns.most}>{live((polled) => number(statistics(polled)?.most))}</td>
      <td data-column={columns.mean}>
        {live((polled) => {
          const mean = statistics(polled)?.mean;
          return mean === undefined || !isNumber(value) ? undefined : words.mean(mean, register);
        })}
      </td>
      <td data-column={columns.errors}>
        {live((polled) => words.errors(statistics(polled)?.errors ?? 0, statistics(polled)?.tries ?? 0))}
      </td>
      <td data-column={columns.age}>
        {live((polled) => {
          const lastAt = statistics(polled)?.lastAt;
          return lastAt === undefined ? undefined : words.age(now.value - lastAt);
        })}
      </td>
    </tr>
  );
}

/** A text that changes by itself: nothing around it is drawn again for it. */
const Live = ({ text }: { readonly text: () => string }) => <>{useMemo(() => computed(text), [text])}</>;

/** Whether a value is drawn in the chart. */
function DrawBox({ index, name }: { readonly index: number; readonly name: string }) {
  const words = useWords('poll');
  const isDrawn = useComputed(() => poll.drawn.value.includes(index)).value;
  const isFull = useComputed(() => poll.drawn.value.length >= MOST_DRAWN).value;
  return (
    <label>
      <input
        type="checkbox"
        aria-label={words.draw(name)}
        checked={isDrawn}
        {...disabledFor(!isDrawn && isFull ? words.drawMost(MOST_DRAWN) : undefined)}
        onChange={({ currentTarget }) => poll.draw(index, currentTarget.checked)}
      />{' '}
      {name}
    </label>
  );
}

function hexOf(items: readonly number[] | undefined): string | undefined {
  if (items === undefined) return undefined;
  const pairs = items.slice(0, HEX_SHOWN).map((item) => formatHex(item, 4).slice(2));
  return `${pairs.join(' ')}${items.length > HEX_SHOWN ? ' …' : ''}`;
}
