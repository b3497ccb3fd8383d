import type { SequenceTexts } from '../../../sequences/index.ts';
import type { RunPhase } from '../../../store/index.ts';
import { disabledFor } from '../../kit/disabled-for.ts';
import { useWords } from '../../parts/words.ts';
import { bus } from '../bus.ts';
import { run } from '../jobs.ts';

interface BarProps {
  readonly sequence: SequenceTexts;
  readonly faults: number;
  readonly onStart: () => void;
}

/** Starts and stops a sequence, and shows how it stands. */
export function RunBar({ sequence, faults, onStart }: BarProps) {
  const words = useWords('sequence');
  // The outcome belongs to the sequence as it was when it was started.
  const told = run.of.value === sequence || run.phase.value.kind === 'not-begun';
  const phase: RunPhase = told ? run.phase.value : { kind: 'idle' };
  const connected = bus.connected.value;
  const running = phase.kind === 'running' || phase.kind === 'asked';
  const last = phase.kind === 'running' && phase.list === 'finally';
  const texts: { readonly [K in RunPhase['kind']]: (phase: Extract<RunPhase, { kind: K }>) => string } = {
    idle: () => '',
    asked: () => words.asked,
    running: ({ list }) => (list === 'finally' ? words.runningLast : words.running),
    ended: ({ how, last }) => words.ended(how, last),
    'not-begun': ({ why }) => words.notBegun[why],
  };
  return (
    <div class="actions run-bar">
      {running ? (
        <button
          type="button"
          class="stop"
          {...disabledFor(phase.kind === 'asked' ? words.asked : undefined)}
          onClick={last ? run.stopLast : run.stopSteps}
        >
          {last ? words.stopLast : words.stop}
        </button>
      ) : (
        <button
          type="button"
          class={connected ? 'first' : undefined}
          {...disabledFor(!connected ? words.notConnected : faults > 0 ? words.faultsLeft(faults) : undefined)}
          onClick={onStart}
        >
          {words.start}
        </button>
      )}
      <span role="status" class="run-said" data-severity={severityOf(phase)}>
        {(texts[phase.kind] as (phase: RunPhase) => string)(phase)}
      </span>
      {!running && faults > 0 && <span class="said">{words.faultsLeft(faults)}</span>}
      {!running && !connected && <span class="said">{words.notConnected}</span>}
    </div>
  );
}

function severityOf(phase: RunPhase): 'error' | 'warning' | undefined {
  if (phase.kind === 'not-begun') return 'warning';
  if (phase.kind !== 'ended') return undefined;
  const ends = [phase.how, phase.last];
  if (ends.includes('lost') || ends.includes('failed')) return 'error';
  return ends.includes('stopped') ? 'warning' : undefined;
}
