import { useComputed } from '@preact/signals';
import { withByte, worst } from '../../../workbench/index.ts';
import { useExplained } from '../current-frame.ts';
import { pasted } from '../pasted.ts';
import { part, Slot } from '../slot.tsx';
import { useSteady } from '../steady.ts';
import { draft, evaluation, page, step } from '../store.ts';
import { useWords } from '../words.ts';
import { CopyActions } from './copy-actions.tsx';
import { ExplanationMenu } from './explanation-menu.tsx';
import { SendPlace } from './send-place.tsx';
import { Strip } from './strip.tsx';

const finder = part(
  ['findings'],
  () => import('./findings.tsx'),
  ({ Finder }) => Finder,
);

export const cause = part(
  ['complaints', 'stripMore'],
  () => import('./cause.tsx'),
  ({ Cause }) => Cause,
);

const pairSegments = part(
  ['stripMore'],
  () => import('./pair-segments.tsx'),
  ({ PairSegments }) => PairSegments,
);

const repairButton = part(
  ['stripMore'],
  () => import('./repair-button.tsx'),
  ({ RepairButton }) => RepairButton,
);

/** Changes a byte of the current frame, as one step. */
function edit(at: number, value: number): void {
  const { frame } = evaluation.peek();
  if (frame) step(withByte(draft.peek(), frame, at, value));
}

/** The frame that is looked into: one with something wrong, one that was pasted, or a refusal. */
function askedFrame() {
  const { frame, stale } = page.shown.value;
  if (frame === undefined || stale !== undefined) return undefined;
  const { bytes, reading } = frame;
  const wrong = reading.outcome.kind !== 'whole' || ['error', 'warning'].includes(worst(reading.problems) ?? '');
  const asked = wrong || (reading.functionCode ?? 0) > 0x7f || pasted.itemWith(bytes);
  return asked ? { draft: draft.value, bytes, reading } : undefined;
}

/** Whether the frame that is shown is wrong in itself. */
function isWrong(): boolean {
  const { reading } = page.shown.value.frame ?? {};
  return reading !== undefined && (reading.outcome.kind !== 'whole' || worst(reading.problems) === 'error');
}

/** The strip of the current frame, which stays in sight while anything below it is edited. */
export function CurrentStrip() {
  const { page: words } = useWords('page');
  const of = useExplained();
  const asked = useComputed(askedFrame).value;
  const stale = useSteady(() => page.shown.value.stale).value;
  const isPaired = useSteady(() => page.pair.value !== undefined).value;
  return (
    <>
      {asked && <Slot part={finder} with={asked} />}
      <Strip
        of={of}
        label={words.bytes}
        edit={stale ? undefined : edit}
        stale={stale}
        isOpen={useSteady(() => page.openReadings.value.length > 0).value}
        cause={<CausePlace asked={asked !== undefined} />}
        actions={<Actions />}
      >
        {isPaired && <Slot part={pairSegments} with={{}} />}
      </Strip>
    </>
  );
}

/** Whether something may have to be said of the frame that is shown, beside its verdict. */
function hasCause(): boolean {
  const { stale, frame } = page.shown.value;
  return !stale && (page.openReadings.value.length > 0 || (frame?.reading.problems.length ?? 0) > 0);
}

function CausePlace({ asked }: { readonly asked: boolean }) {
  const needed = useSteady(hasCause).value || asked;
  return needed && <Slot part={cause} with={{ asked }} />;
}

function Actions() {
  const wrong = useSteady(isWrong).value;
  return (
    <>
      {wrong && <Slot part={repairButton} with={{}} />}
      <CopyActions wrong={wrong} />
      <SendPlace />
      <ExplanationMenu />
    </>
  );
}
