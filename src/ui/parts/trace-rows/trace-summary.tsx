import type { TraceView } from '../../../store/index.ts';
import { type SeenFault, seenCounts, traceSeverity } from '../../../workbench/index.ts';
import { useWords } from '../words.ts';
import './trace-summary.css';

/** Units that have a button each. */
const MOST_UNITS = 12;
const MILLISECOND = 1000;

interface SummaryProps {
  readonly of: TraceView<File>;
}

/** What a filter is written as for a kind of fault. */
const filterFor = (kind: SeenFault): string => (kind === 'checksum' ? 'crc' : kind);

/** What is in a trace, and what is wrong in it: each part shows its rows. */
export function TraceSummaryLine({ of }: SummaryProps) {
  const words = useWords('trace');
  const summary = of.summary.value;
  if (summary === undefined) return null;
  const { units, replyTime } = summary;
  const found = [...seenCounts(summary, of.pieces.value)];
  return (
    <fieldset class="trace-summary in-row" aria-label={words.summary}>
      <Part of={of} filter="" name={words.size(summary)} />
      {found.map(([kind, count]) => (
        <Part
          key={kind}
          of={of}
          filter={filterFor(kind)}
          name={words.faultCount(kind, count)}
          severity={traceSeverity(kind)}
        />
      ))}
      {found.length === 0 && <span class="said">{words.noFaults}</span>}
      {units.slice(0, MOST_UNITS).map((unit) => (
        <Part key={unit} of={of} filter={`unit:${unit}`} name={words.units([unit])} />
      ))}
      {units.length > MOST_UNITS && <span class="said">{words.moreUnits(units.length - MOST_UNITS)}</span>}
      {replyTime && (
        <Part
          of={of}
          filter={`slow>=${Math.floor(replyTime.maximum / MILLISECOND)}`}
          name={words.replyTime(replyTime.median, replyTime.maximum)}
        />
      )}
    </fieldset>
  );
}

interface PartProps extends SummaryProps {
  readonly filter: string;
  readonly name: string;
  readonly severity?: 'error' | 'warning';
}

/** A part of the summary: pressed, it is what the list shows; pressed again, the list shows all. */
function Part({ of, filter, name, severity }: PartProps) {
  const words = useWords('trace');
  const isOn = of.applied.value === filter;
  return (
    <button
      type="button"
      data-severity={severity}
      aria-pressed={isOn}
      title={filter === '' ? words.allRows(name) : words.onlyRows(name)}
      onClick={() => of.setFilter(isOn ? '' : filter)}
    >
      {name}
    </button>
  );
}

/** Why many exchanges fail, each with the faults it explains, which lead to their rows. */
export function TraceCauses({ of }: SummaryProps) {
  const words = useWords('trace');
  const causes = of.causes.value;
  if (causes.length === 0) return null;
  return (
    <ul class="problems edges trace-causes" aria-label={words.causes}>
      {causes.map((cause) => (
        <li key={cause.code} data-severity={traceSeverity(cause.kind)}>
          {words.cause(cause)} <Part of={of} filter={`cause:${cause.code}`} name={words.evidence(cause)} />
        </li>
      ))}
    </ul>
  );
}
