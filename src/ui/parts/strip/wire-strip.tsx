import { signal } from '@preact/signals';
import { inPairs, type Span, toHex } from '../../../modbus/index.ts';
import type { Words } from '../../../words/index.ts';
import { character, worst } from '../../../workbench/index.ts';
import { useSteady } from '../steady.ts';
import { evaluation, page } from '../store.ts';
import { useWords } from '../words.ts';

/** Whether long runs are shown by their ends only. */
export const folded = signal(false);

/** A run of more bytes than this can be folded, to so many at each end. */
const LONG = 16;
const ENDS = 4;
/** No legal frame has a longer field; of a longer one the beginning is drawn, and its ends. */
const MOST = 600;
const BEGINNING = 256;

/** The frame as the wire carries it: every byte a cell, in the colour of its field. */
export function WireStrip() {
  const { page: words } = useWords('page');
  const spans = useSteady(() => evaluation.value.frame?.reading.spans ?? []).value;
  return (
    <ol class="strip" aria-label={words.bytes}>
      {spans.map((span) => (
        <StripField key={`${span.name}-${span.from}`} span={span} />
      ))}
    </ol>
  );
}

/** What is wrong with the bytes of a field, at worst. */
function severityOf({ from, to }: Span) {
  const problems = evaluation.value.frame?.reading.problems ?? [];
  return worst(problems.filter(({ span }) => span.from < to && span.to > from));
}

interface StripProps {
  readonly span: Span;
}

function StripField({ span }: StripProps) {
  const words = useWords('page');
  const { name, kind, from, to } = span;
  const severity = useSteady(() => severityOf(span), [span]).value;
  const fold = folded.value;
  const label = words.labels[name] ?? name;
  const long = to - from > LONG;
  const head = fold && long ? from + ENDS : to - from > MOST ? from + BEGINNING : to;
  const tail = to - ENDS;
  return (
    <li class="field" data-kind={kind} data-severity={severity}>
      <span class="name" title={label}>
        {words.short[name] ?? label.toLowerCase()}
        {severity && <b class="mark">{words.page.severities[severity]}</b>}
        {long && (
          <button type="button" aria-pressed={fold} onClick={() => (folded.value = !folded.value)}>
            {words.page.fold}
          </button>
        )}
      </span>
      <span class="bytes">
        <Cells span={span} from={from} to={head} />
        {head < to && (
          <>
            <span class="byte" data-from={head} data-to={tail}>
              …<small>{words.page.foldedBytes(tail - head)}</small>
            </span>
            <Cells span={span} from={tail} to={to} />
          </>
        )}
      </span>
    </li>
  );
}

interface CellsProps extends StripProps {
  readonly from: number;
  readonly to: number;
}

/** Cells that are drawn together: a character typed changes few bytes. */
const RUN = 16;

/** The bytes from `from` to `to` of a field. */
const Cells = ({ span, from, to }: CellsProps) => (
  <>
    {Array.from({ length: Math.ceil((to - from) / RUN) }, (_, index) => from + index * RUN).map((at) => (
      <Run key={at} span={span} from={at} to={Math.min(at + RUN, to)} />
    ))}
  </>
);

function Run({ span, from, to }: CellsProps) {
  const { page: words } = useWords('page');
  const hex = useSteady(() => {
    const { frame } = evaluation.value;
    return frame ? toHex(frame.bytes, from, to) : '';
  }, [from, to]).value;
  const isAscii = page.transport.value === 'ascii';
  return (
    <>
      {(hex.match(/../g) ?? []).map((pair, index) => {
        const at = from + index;
        return (
          <span class="byte" key={at} data-from={at} data-to={at + 1}>
            {isAscii ? character(Number.parseInt(pair, 16)) : pair}
            <small>
              {at}
              {isAscii ? ` ${pair}` : order(span, at, words)}
            </small>
          </span>
        );
      })}
    </>
  );
}

/** Which byte of a pair this is, where the order matters. */
function order({ kind, from, to }: Span, at: number, words: Words['page']): string {
  const isFirst = (at - from) % 2 === 0;
  if (kind === 'checksum') return ` ${isFirst ? words.low : words.high}`;
  return inPairs.has(kind) && (to - from) % 2 === 0 ? ` ${isFirst ? words.high : words.low}` : '';
}
