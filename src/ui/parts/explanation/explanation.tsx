import { computed, type ReadonlySignal, signal } from '@preact/signals';
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
}

/** Lines that are drawn until more are asked for; hardly a legal frame has as many. */
const FIRST = 600;

/** Lines that are drawn together: so many that few groups are watched, so few that little is drawn out of sight. */
const GROUP = 12;

/** A line for each field and each item of a list: where, which bytes, which bits, and what they mean here. */
export function Explanation({ of }: { readonly of: ReadonlySignal<ExplainedFrame | undefined> }) {
  const { columns, everyByte, characterColumn } = useWords('page').page;
  const tools = useWords('tools');
  const words = useExplanationWords();
  const [most, setMost] = useState(FIRST);
  const lines = useMemo(() => computed(() => (of.value ? linesOf({ ...of.value, words }) : [])), [of, words]);
  const count = useSteady(() => lines.value.length, [lines]).value;
  const isAscii = useSteady(() => of.value?.reading.transport === 'ascii', [of]).value;
  const groups = Math.ceil(Math.min(count, most) / GROUP);
  return (
    <section class="panel" aria-labelledby="every-byte">
      <h2 id="every-byte">{everyByte}</h2>
      <table class="explanation">
        <thead>
          <tr>
            <th scope="col">{columns.byte}</th>
            <th scope="col">{columns.hex}</th>
            <th scope="col">{columns.decimal}</th>
            <th scope="col">{isAscii ? characterColumn : columns.bits}</th>
            <th scope="col">{columns.means}</th>
            <th scope="col">{columns.section}</th>
          </tr>
        </thead>
        {Array.from({ length: groups }, (_, index) => (
          <Group key={index} lines={lines} from={index * GROUP} />
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
    </section>
  );
}

/** The explanation of a frame that does not change. */
export const ExplanationOf = ({ reading, bytes, names }: ExplainedFrame) => {
  const of = useMemo(() => signal({ reading, bytes, names }), [reading, bytes, names]);
  return <Explanation of={of} />;
};

interface GroupProps {
  readonly lines: ReadonlySignal<readonly LazyExplanationRow[]>;
  readonly from: number;
}

/** Lines that are neither laid out nor drawn while they are out of sight. */
function Group({ lines, from }: GroupProps) {
  const element = useRef<HTMLTableSectionElement>(null);
  const shown = useSignalWhenSeen(lines, element);
  const count = useSteady(() => Math.min(shown.value.length - from, GROUP)).value;
  return (
    <tbody ref={element} style={{ '--rows': count }}>
      {Array.from({ length: count }, (_, index) => (
        <Line key={index} lines={shown} at={from + index} />
      ))}
    </tbody>
  );
}

interface LineProps {
  readonly lines: ReadonlySignal<readonly LazyExplanationRow[]>;
  readonly at: number;
}

function Line({ lines, at }: LineProps) {
  const row = useSteady(() => lines.value[at]?.(), [lines, at]).value;
  if (row === undefined) return null;
  return (
    <tr
      data-kind={row.kind}
      data-severity={row.severity}
      data-from={row.from}
      data-to={row.to}
      class={row.item ? 'item' : undefined}
    >
      <td class="mono offset">{row.offset}</td>
      <td class="mono hex">{row.hex}</td>
      <td class="mono decimal">{row.decimal}</td>
      <td class="mono bits">{row.characters || row.bits}</td>
      <td class="means">
        {row.label && <b>{row.label}. </b>}
        {row.meaning}
        {row.problems && <span class="problem">{row.problems}</span>}
      </td>
      <td class="section">{row.section}</td>
    </tr>
  );
}
