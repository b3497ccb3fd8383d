import { isBitTable } from '../../../devices/index.ts';
import { formatHex } from '../../../notation/index.ts';
import { isNumber, MOST_DRAWN, type Polled, type PolledValue } from '../../../workbench/index.ts';
import { poll } from './poll.ts';
import { pollWords as words } from './poll-words.ts';

/** Registers of a value that are shown in hexadecimal; a text may have a hundred. */
const HEX_SHOWN = 4;

interface TableProps {
  readonly polled: Polled;
  /** Values by their place among all. */
  readonly shown: readonly number[];
}

/** Each value with what was read of it last, and in all. */
export function ValueTable({ polled, shown }: TableProps) {
  const { columns } = words;
  // The time of the window, counted as the samples are.
  const now = performance.timeOrigin + performance.now();
  return (
    <div class="poll-table">
      <table>
        <thead>
          <tr>
            {[
              columns.name,
              columns.place,
              columns.last,
              columns.hex,
              columns.least,
              columns.most,
              columns.mean,
              columns.errors,
              columns.age,
            ].map((column) => (
              <th key={column} scope="col">
                {column}
              </th>
            ))}
          </tr>
        </thead>
        <tbody>
          {shown.map((index) => {
            const value = polled.source.values[index];
            return value && <ValueRow key={index} polled={polled} index={index} value={value} now={now} />;
          })}
        </tbody>
      </table>
    </div>
  );
}

interface RowProps {
  readonly polled: Polled;
  readonly index: number;
  readonly value: PolledValue;
  readonly now: number;
}

function ValueRow({ polled: { samples, drawn, items }, index, value, now }: RowProps) {
  const { name, place, register } = value;
  const { columns, missing } = words;
  const statistics = samples.statistics[index];
  const last = samples.last[index];
  const isDrawn = drawn.includes(index);
  const number = (one: number | bigint | undefined) =>
    one === undefined || !isNumber(value)
      ? missing
      : isBitTable(register.table)
        ? String(one)
        : words.inUnit(one, register);
  const mean = statistics?.mean;
  const doubtful = statistics?.isDoubtful === true;
  const failed = statistics !== undefined && statistics.tries > 0 && items[index] === undefined && !doubtful;
  return (
    <tr data-failed={failed ? '' : undefined} data-severity={doubtful ? 'warning' : undefined}>
      <th scope="row">
        {isNumber(value) ? (
          <label>
            <input
              type="checkbox"
              aria-label={words.draw(name)}
              checked={isDrawn}
              disabled={!isDrawn && drawn.length >= MOST_DRAWN}
              onChange={({ currentTarget }) => poll.draw(index, currentTarget.checked)}
            />{' '}
            {name}
          </label>
        ) : (
          name
        )}
      </th>
      <td class="mono" data-label={columns.place}>
        {place}
      </td>
      <td class="last" data-label={columns.last}>
        {last === undefined ? missing : words.reading(last, register)}{' '}
        {failed && <span class="error">{words.failed}</span>}
        {doubtful && <span class="doubtful">{words.doubtful}</span>}
      </td>
      <td class="mono" data-label={columns.hex}>
        {isBitTable(register.table) ? missing : hexOf(items[index])}
      </td>
      <td data-label={columns.least}>{number(statistics?.least)}</td>
      <td data-label={columns.most}>{number(statistics?.most)}</td>
      <td data-label={columns.mean}>{mean === undefined || !isNumber(value) ? missing : words.mean(mean, register)}</td>
      <td data-label={columns.errors}>{words.errors(statistics?.errors ?? 0, statistics?.tries ?? 0)}</td>
      <td data-label={columns.age}>
        {statistics?.lastAt === undefined ? missing : words.age(now - statistics.lastAt)}
      </td>
    </tr>
  );
}

function hexOf(items: readonly number[] | undefined): string {
  if (items === undefined) return words.missing;
  const pairs = items.slice(0, HEX_SHOWN).map((item) => formatHex(item, 4).slice(2));
  return `${pairs.join(' ')}${items.length > HEX_SHOWN ? ' …' : ''}`;
}
