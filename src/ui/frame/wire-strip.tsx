import { signal } from '@preact/signals';
import { inPairs, type Reading, type Severity, type Span, toHex } from '../../modbus/index.ts';
import { character, worst } from '../../workbench/index.ts';
import { words } from '../parts/page-words.ts';

/** Whether long runs are shown by their ends only. */
export const folded = signal(false);

/** A run of more bytes than this can be folded, to so many at each end. */
const LONG = 16;
const ENDS = 4;
/** No legal frame has a longer field; of a longer one the beginning is drawn, and its ends. */
const MOST = 600;
const BEGINNING = 256;

/** The frame as the wire carries it: every byte a cell, in the colour of its field. */
export function WireStrip({ reading, bytes }: { reading: Reading; bytes: Uint8Array }) {
  const ascii = reading.transport === 'ascii';
  return (
    <ol class="strip" aria-label={words.page.bytes}>
      {reading.spans.map((span) => {
        const problems = reading.problems.filter(({ span: at }) => at.from < span.to && at.to > span.from);
        return (
          <StripField
            key={`${span.name}-${span.from}`}
            name={span.name}
            kind={span.kind}
            from={span.from}
            to={span.to}
            hex={toHex(bytes, span.from, span.to)}
            ascii={ascii}
            severity={worst(problems)}
          />
        );
      })}
    </ol>
  );
}

interface FieldProps extends Pick<Span, 'name' | 'kind' | 'from' | 'to'> {
  readonly hex: string;
  readonly ascii: boolean;
  readonly severity: Severity | undefined;
}

/** The cells of a field. What it is given is compared by value, and it reads a signal: only a field that changes is drawn. */
function StripField({ name, kind, from, to, hex, ascii, severity }: FieldProps) {
  const fold = folded.value;
  const label = words.labels[name] ?? name;
  const pairs = hex.match(/../g) ?? [];
  const long = pairs.length > LONG;
  const head = fold && long ? ENDS : pairs.length > MOST ? BEGINNING : pairs.length;
  const cell = (pair: string, index: number) => (
    <span class="byte" key={index} data-from={from + index} data-to={from + index + 1}>
      {ascii ? character(Number.parseInt(pair, 16)) : pair}
      <small>
        {from + index}
        {ascii ? ` ${pair}` : order({ kind, from, to }, index)}
      </small>
    </span>
  );
  const tail = pairs.length - ENDS;
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
        {head < pairs.length ? (
          <>
            {pairs.slice(0, head).map(cell)}
            <span class="byte" data-from={from + head} data-to={from + tail}>
              …<small>{words.page.foldedBytes(tail - head)}</small>
            </span>
            {pairs.slice(tail).map((pair, index) => cell(pair, tail + index))}
          </>
        ) : (
          pairs.map(cell)
        )}
      </span>
    </li>
  );
}

/** Which byte of a pair this is, where the order matters. */
function order({ kind, from, to }: Pick<Span, 'kind' | 'from' | 'to'>, index: number): string {
  if (kind === 'checksum') return ` ${index === 0 ? words.page.low : words.page.high}`;
  const even = (to - from) % 2 === 0;
  return inPairs.has(kind) && even ? ` ${index % 2 === 0 ? words.page.high : words.page.low}` : '';
}
