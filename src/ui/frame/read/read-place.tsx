import { useComputed } from '@preact/signals';
import { worst } from '../../../workbench/index.ts';
import { pasted } from '../../parts/pasted.ts';
import { part, Slot } from '../../parts/slot.tsx';
import { draft, evaluation } from '../../parts/store.ts';

const findings = part(
  ['read', 'findings'],
  () => import('./findings.tsx'),
  ({ Findings }) => Findings,
);

/** The place for findings: about a frame that was pasted, and about one with something wrong. */
export function FindingsPlace() {
  const asked = useComputed(askedFrame).value;
  return asked && <Slot part={findings} with={asked} />;
}

function askedFrame() {
  const { frame } = evaluation.value;
  if (frame === undefined) return undefined;
  const { bytes, reading } = frame;
  const wrong = reading.outcome.kind !== 'whole' || ['error', 'warning'].includes(worst(reading.problems) ?? '');
  return wrong || pasted.contextOf(bytes, undefined) ? { draft: draft.value, bytes, reading } : undefined;
}
