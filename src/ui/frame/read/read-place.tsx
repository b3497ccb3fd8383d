import { useComputed } from '@preact/signals';
import { useState } from 'preact/hooks';
import { worst } from '../../../workbench/index.ts';
import { FoldPanel } from '../../kit/fold.tsx';
import { useCommand } from '../../parts/commands.ts';
import { pasted } from '../../parts/pasted.ts';
import { part, Slot } from '../../parts/slot.tsx';
import { draft, evaluation } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';

const panel = part(
  ['read'],
  () => import('./read-panel.tsx'),
  ({ ReadPanel }) => ReadPanel,
);

/** The panel for pasted text. It is loaded when it is opened. */
export function ReadPlace() {
  const { title, intro } = useWords('page').page.panels.read;
  const opened = pasted.opened.value;
  const [asked, setAsked] = useState(0);
  useCommand('focus-input', () => {
    pasted.opened.value = true;
    setAsked((times) => times + 1);
  });
  useCommand('close', opened ? () => (pasted.opened.value = false) : undefined);
  return (
    <FoldPanel
      class="read-panel"
      title={title}
      hint={intro}
      keep
      open={opened}
      onToggle={(open) => {
        pasted.opened.value = open;
      }}
    >
      {() => <Slot part={panel} with={{ asked }} />}
    </FoldPanel>
  );
}

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
