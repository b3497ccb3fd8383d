import type { TargetedMouseEvent } from 'preact';
import type { TraceView } from '../../../store/index.ts';
import type { TraceMark } from '../../../workbench/index.ts';
import { useWords } from '../words.ts';

/** Rows that are named for those who do not see the strip. */
const NAMED = 10;

/** Where in the list the faults are, beside its scrollbar: a click goes to the nearest. The keys for faults do the same. */
export function MarkStrip({ of }: { readonly of: TraceView<File> }) {
  const words = useWords('trace');
  const marks = of.marks.value;
  const count = of.rowsKept.value;
  const go = ({ currentTarget, clientY }: TargetedMouseEvent<HTMLButtonElement>) => {
    const { top, height } = currentTarget.getBoundingClientRect();
    const row = nearest(marks, ((clientY - top) / height) * count);
    if (row !== undefined) of.choose(row);
  };
  const path = (severity: TraceMark['severity']) =>
    marks.flatMap((mark) => (mark.severity === severity ? [`M0 ${(mark.row + 0.5) / count}h1`] : [])).join('');
  return (
    <button
      type="button"
      class="mark-strip"
      tabIndex={-1}
      aria-label={words.marks(
        marks.slice(0, NAMED).map(({ row }) => row),
        Math.max(0, marks.length - NAMED),
      )}
      onClick={go}
    >
      <svg viewBox="0 0 1 1" preserveAspectRatio="none" aria-hidden="true">
        <path d={path('warning')} data-severity="warning" />
        <path d={path('error')} data-severity="error" />
      </svg>
    </button>
  );
}

function nearest(marks: readonly TraceMark[], row: number): number | undefined {
  let best: TraceMark | undefined;
  for (const mark of marks) if (!best || Math.abs(mark.row - row) < Math.abs(best.row - row)) best = mark;
  return best?.row;
}
