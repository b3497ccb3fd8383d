import { type RunPhase, run } from './run.ts';
import { sequenceWords as words } from './sequence-words.ts';

interface BarProps {
  readonly connected: boolean;
  readonly phase: RunPhase;
  readonly faults: number;
  readonly onStart: () => void;
}

/** Starts a sequence and stops it, and says how it stands. */
export function RunBar({ connected, phase, faults, onStart }: BarProps) {
  const running = phase.kind === 'running' || phase.kind === 'asked';
  const last = phase.kind === 'running' && phase.list === 'finally';
  return (
    <div class="actions run-bar">
      {running ? (
        <button type="button" class="first" disabled={phase.kind === 'asked'} onClick={last ? run.stopLast : run.stop}>
          {last ? words.stopLast : words.stop}
        </button>
      ) : (
        <button type="button" class="first" disabled={!connected || faults > 0} onClick={onStart}>
          {words.start}
        </button>
      )}
      <span role="status" class="run-said" data-severity={severityOf(phase)}>
        {said(phase)}
      </span>
      {!running && faults > 0 && <span class="said">{words.faultsLeft(faults)}</span>}
      {!running && !connected && <span class="said">{words.notConnected}</span>}
    </div>
  );
}

function said(phase: RunPhase): string {
  switch (phase.kind) {
    case 'idle':
      return '';
    case 'asked':
      return words.asked;
    case 'running':
      return phase.list === 'finally' ? words.runningLast : words.running;
    case 'ended':
      return words.ended(phase.how, phase.last);
    case 'not-begun':
      return words.notBegun[phase.why];
  }
}

function severityOf(phase: RunPhase): 'error' | 'warning' | undefined {
  if (phase.kind === 'not-begun') return 'warning';
  if (phase.kind !== 'ended') return undefined;
  const ends = [phase.how, phase.last];
  if (ends.includes('lost') || ends.includes('failed')) return 'error';
  return ends.includes('stopped') ? 'warning' : undefined;
}
