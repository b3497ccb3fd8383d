import { computed, type ReadonlySignal, useSignal } from '@preact/signals';
import { useMemo, useRef, useState } from 'preact/hooks';
import type { Reading } from '../../../modbus/index.ts';
import { type FrameNames, type LazyExplanationRow, linesOf } from '../../../workbench/index.ts';
import { useSignalWhenSeen } from '../../kit/signal-when-seen.ts';
import { useSteady } from '../steady.ts';
import { useWords } from '../words.ts';
import './explanation.css';
import { useExplanationWords } from './explanation-words.ts';

/** A frame that is explained, with what a device calls what is in it. */
export interface ExplainedFrame {
  readonly reading: Reading;
  readonly bytes: Uint8Array;
  readonly names?: FrameNames | undefined;
  /** Whether its address was typed in six digits. */
  readonly sixDigits?: boolean | undefined;
}

/** Lines that are drawn until more are asked for; hardly a legal frame has as many. */
const FIRST = 600;

/** Lines that are drawn together: so many that few groups are watched, so few that little is drawn out of sight. */
const GROUP = 12;

/** Which lines are unfolded: all or none, but for those with these keys. */
interface Unfolding {
  readonly all: boolean;
  readonly but: ReadonlySet<string>;
}

const FOLDED: Unfolding = { all: false, but: new Set() };

const turned = ({ all, but }: Unfolding, key: string): Unfolding => ({
  all,
  but: but.has(key) ? new Set([...but].filter((each) => each !== key)) : new Set([...but, key]),
});

/** A line for each field and each item of a list: where, which bytes, and what they mean here. Single bytes unfold. */
export function Explanation({ of }: { readonly of: ReadonlySignal<ExplainedFrame | undefined> }) {
  const { columns, everyByte, characterColumn } = useWords('page').page;
  const tools = useWords('tools');
  const words = useExplanationWords(useSteady(() => (of.value?.reading.problems.length ?? 0) > 0, [of]).value);
  const [most, setMost] = useState(FIRST);
  const unfolding = useSignal(FOLDED);
  const lines = useMemo(
    () =>
      computed(() => {
        const { all, but } = unfolding.value;
        return of.value ? linesOf({ ...of.value, words }, (key) => all !== but.has(key)) : [];
      }),
    [of, words],
  );
  const count = useSteady(() => lines.value.length, [lines]).value;
  const isAscii = useSteady(() => of.value?.reading.transport === 'ascii', [of]).value;
  const { all } = unfolding.value;
  const turn = useMemo(
    () => (key: string) => {
      unfolding.value = turned(unfolding.peek(), key);
    },
    [],
  );
  const groups = Math.ceil(Math.min(count, most) / GROUP);
  return (
    <div class="explanation-place">
      <table class="explanation" aria-label={everyByte} data-ascii={isAscii ? '' : undefined}>
        <thead>
          <tr>
            <th scope="col">{columns.byte}</th>
            <th scope="col">{columns.hex}</th>
            {isAscii && <th scope="col">{characterColumn}</th>}
            <th scope="col" class="means">
              {columns.means}
              <button
                type="button"
                class="quiet"
                aria-pressed={all}
                onClick={() => {
                  unfolding.value = { all: !all, but: FOLDED.but };
                }}
              >
                {tools.unfoldAll}
              </button>
            </th>
          </tr>
        </thead>
        {Array.from({ length: groups }, (_, index) => (
          <Group
            key={index}
            lines={lines}
            from={index * GROUP}
            isAscii={isAscii}
            unfoldLabel={tools.unfold}
            onTurn={turn}
          />
        ))}
      </table>
      {count > most && (
        <p class="said">
          {tools.moreLines(count - most)}{' '}
          <button type="button" onClick={() => setMost(most + FIRST)}>
            {tools.showMoreLines(Math.min(FIRST, count - most))}
          </button>
        </p>
      )}
    </div>
  );
}

interface LinesProps {
  readonly lines: ReadonlySignal<readonly LazyExplanationRow[]>;
  readonly isAscii: boolean;
  /** The name of the button that shows the single bytes of others. */
  readonly unfoldLabel: (offset: string) => string;
  /** Unfolds the line with this key, or folds it. */
  readonly onTurn: (key: string) => void;
}

/** Lines that are neither laid out nor drawn while they are out of sight. */
function Group({ lines, from, ...all }: LinesProps & { readonly from: number }) {
  const element = useRef<HTMLTableSectionElement>(null);
  const shown = useSignalWhenSeen(lines, element);
  const count = useSteady(() => Math.min(shown.value.length - from, GROUP)).value;
  return (
    <tbody ref={element} style={{ '--rows': count }}>
      {Array.from({ length: count }, (_, index) => (
        <Line key={index} lines={shown} at={from + index} {...all} />
      ))}
    </tbody>
  );
}

function Line({ lines, at, isAscii, unfoldLabel, onTurn }: LinesProps & { readonly at: number }) {
  const row = useSteady(() => lines.value[at]?.(), [lines, at]).value;
  if (row === undefined) return null;
  return (
    <tr
      data-kind={row.kind}
      data-severity={row.severity}
      data-from={row.from}
      data-to={row.to}
      data-depth={row.depth || undefined}
    >
      <td class="mono offset">{row.offset}</td>
      <td class="mono hex">{row.hex}</td>
      {isAscii && <td class="mono characters">{row.characters}</td>}
      <td class="means">
        {row.unfolded !== undefined && (
          <button
            type="button"
            class="quiet unfold"
            aria-expanded={row.unfolded}
            aria-label={unfoldLabel(row.offset)}
            title={unfoldLabel(row.offset)}
            onClick={() => onTurn(row.key)}
          >
            {row.unfolded ? '▾' : '▸'}
          </button>
        )}
        {row.depth > 0 && row.bits && <span class="mono bits">{row.bits} </span>}
        {row.label && <b>{row.label}. </b>}
        {row.name && <b class="named">{row.name} </b>}
        <span class="rule">{row.meaning}</span> <span class="section">{row.section}</span>
        {row.problems && <span class="problem">{row.problems}</span>}
      </td>
    </tr>
  );
}
