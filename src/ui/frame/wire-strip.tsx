import type { Reading, Span } from '../../modbus/index.ts';
import { toHex } from '../../modbus/index.ts';
import { words } from '../language.ts';
import { character, worst } from './rows.ts';

/** Kinds whose bytes are pairs with the high one first. */
const PAIRS = new Set(['address', 'quantity', 'number', 'choice', 'flag', 'registers', 'envelope', 'count']);

/** The frame as the wire carries it: every byte a cell, in the colour of its field. */
export function WireStrip({ reading, bytes }: { reading: Reading; bytes: Uint8Array }) {
  return (
    <ol class="strip" aria-label={words.page.bytes}>
      {reading.spans.map((span) => (
        <Field key={`${span.name}-${span.from}`} reading={reading} bytes={bytes} span={span} />
      ))}
    </ol>
  );
}

function Field({ reading, bytes, span }: { reading: Reading; bytes: Uint8Array; span: Span }) {
  const problems = reading.problems.filter(({ span: at }) => at.from < span.to && at.to > span.from);
  const severity = worst(problems);
  const label = words.labels[span.name] ?? span.name;
  return (
    <li class="field" data-kind={span.kind} data-severity={severity}>
      <span class="name" title={label}>
        {words.short[span.name] ?? label.toLowerCase()}
        {severity && <b class="mark">{words.page.severities[severity]}</b>}
      </span>
      <span class="bytes">
        {Array.from(bytes.subarray(span.from, span.to), (byte, index) => (
          <Cell key={span.from + index} reading={reading} span={span} byte={byte} index={index} />
        ))}
      </span>
    </li>
  );
}

function Cell({ reading, span, byte, index }: { reading: Reading; span: Span; byte: number; index: number }) {
  const at = span.from + index;
  const ascii = reading.transport === 'ascii';
  return (
    <span class="byte" data-from={at} data-to={at + 1}>
      {ascii ? character(byte) : toHex(Uint8Array.of(byte))}
      <small>
        {at}
        {ascii ? ` ${toHex(Uint8Array.of(byte))}` : order(span, index)}
      </small>
    </span>
  );
}

/** Which byte of a pair this is, where the order matters. */
function order({ kind, from, to }: Span, index: number): string {
  if (kind === 'checksum') return ` ${index === 0 ? words.page.low : words.page.high}`;
  const even = (to - from) % 2 === 0;
  return PAIRS.has(kind) && even ? ` ${index % 2 === 0 ? words.page.high : words.page.low}` : '';
}
