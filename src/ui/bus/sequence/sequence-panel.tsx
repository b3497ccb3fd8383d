import { useLayoutEffect, useMemo, useRef, useState } from 'preact/hooks';
import { formatBytes } from '../../../notation/index.ts';
import {
  duplicateAt,
  insertAt,
  listNames,
  moveAt,
  movedTo,
  neighbour,
  newStep,
  placeKey,
  readSequence,
  removeAt,
  type SequenceTexts,
  type StepKind,
  type StepPlace,
  stepAt,
  withField,
} from '../../../sequences/index.ts';
import { programForSequence } from '../../../workbench/index.ts';
import { disabledFor } from '../../kit/disabled-for.ts';
import { Messages } from '../../kit/messages.tsx';
import { ProgramButton } from '../../parts/program/program-button.tsx';
import { draft, evaluation } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { run, sequences } from '../jobs.ts';
import { Head } from './head.tsx';
import { RunBar } from './run-bar.tsx';
import { SequenceFiles } from './sequence-files.tsx';
import './sequence.css';
import { type StepAction, type StepActs, StepList } from './sequence-steps.tsx';

interface Message {
  readonly lines: readonly string[];
  /** The control that gets the focus after the next drawing, since the one that had it may be gone. */
  readonly focus?: string | undefined;
}

/** Frames, waits and conditions one after another: made, kept, and carried out. */
export function SequencePanel() {
  const words = useWords('sequence');
  const root = useRef<HTMLDivElement>(null);
  const [message, setMessage] = useState<Message>({ lines: [] });
  const tell = (lines: readonly string[], focus?: string): void => setMessage({ lines, focus });
  useLayoutEffect(() => {
    if (message.focus === undefined) return;
    root.current?.querySelector<HTMLElement>(`[data-focus="${CSS.escape(message.focus)}"]:not(:disabled)`)?.focus();
  }, [message]);

  const edit = (next: SequenceTexts, change = '', focus?: string): void => {
    const before = sequences.current.value;
    const isCopied = before && !sequences.isCustom(before);
    const name = sequences.edit(next, change);
    if (name === undefined) tell([words.tooBig]);
    else tell(isCopied ? [words.copied(name)] : [], focus);
  };
  const add = (current: SequenceTexts, place: StepPlace, kind: StepKind | 'frame'): void => {
    const { frame } = evaluation.value;
    const { kind: direction, transport } = draft.value;
    if (kind !== 'frame') edit(insertAt(current, place, newStep(kind)));
    else if (frame === undefined || direction !== 'request' || transport !== current.transport)
      tell([words.noCurrentFrame(current.transport)]);
    else edit(insertAt(current, place, newStep('send', { bytes: formatBytes(frame.bytes) })));
  };
  const acts: StepActs = {
    change(place, field, text) {
      const current = sequences.current.value;
      if (current) edit(withField(current, place, field, text), `${placeKey(place)} ${field}`);
    },
    act(place, action) {
      const current = sequences.current.value;
      if (current) edit(...acted(current, place, action));
    },
    add(place, kind) {
      const current = sequences.current.value;
      if (current) add(current, place, kind);
    },
  };

  const locked = run.running.value;
  const sequence = locked ? run.of.value : sequences.current.value;
  const reading = useMemo(() => sequence && readSequence(sequence), [sequence]);
  if (sequence === undefined || reading === undefined) return null;
  const faults = reading.kind === 'faults' ? reading.faults : [];
  return (
    <div class="sequence stack" ref={root}>
      <p class="said">{words.intro}</p>
      <Unkept />
      <Head sequence={sequence} locked={locked} onEdit={edit} onMessage={tell} />
      {listNames.map((list) => (
        <section key={list} aria-labelledby={`sequence-${list}`}>
          <h3 id={`sequence-${list}`}>{words.lists[list]}</h3>
          {sequence[list].length === 0 && <p class="said">{list === 'finally' ? words.noFinally : words.noSteps}</p>}
          <StepList
            sequence={sequence}
            steps={sequence[list]}
            place={{ list, at: [] }}
            faults={faults}
            acts={acts}
            locked={locked}
          />
        </section>
      ))}
      <Messages lines={message.lines} />
      <div class="actions">
        <button
          type="button"
          data-focus="undo"
          {...disabledFor(locked ? words.locked : sequences.canUndo.value ? undefined : words.nothingToUndo)}
          onClick={() => {
            sequences.undo();
            tell([words.undone]);
          }}
        >
          {words.undo}
        </button>
        <SequenceFiles sequence={sequence} onMessage={tell} locked={locked} />
        <ProgramButton
          label={words.program}
          name={sequence.name}
          wanted={() => programForSequence(reading.kind === 'sequence' ? reading.sequence : undefined)}
        />
      </div>
      <RunBar
        sequence={sequence}
        faults={faults.length}
        onStart={() => reading.kind === 'sequence' && run.start(reading.sequence, sequence)}
      />
    </div>
  );
}

/** Why changes are not kept, and which stored sequences cannot be read. */
function Unkept() {
  const words = useWords('sequence');
  const { value: notKept } = sequences.notKept;
  const { value: bad } = sequences.bad;
  return (
    <>
      {notKept && <p class="said error">{words.notKept[notKept]}</p>}
      {bad.length > 0 && (
        <div class="said error">
          <p>{words.badStored(bad.length)}</p>
          {bad.flatMap(({ number, name, faults }) =>
            faults.slice(0, 1).map((fault) => <p key={number}>{words.badEntry(number, name, fault)}</p>),
          )}
        </div>
      )}
    </>
  );
}

/** The sequence after an action, the name of the change, and the control that gets the focus. */
function acted(
  sequence: SequenceTexts,
  place: StepPlace,
  action: StepAction,
): readonly [SequenceTexts, string, string] {
  switch (action) {
    case 'up':
    case 'down': {
      const by = action === 'up' ? -1 : 1;
      const to = movedTo(sequence, place, by) ?? place;
      return [moveAt(sequence, place, by), '', `${action} ${placeKey(to)}`];
    }
    case 'duplicate':
      return [duplicateAt(sequence, place), '', `duplicate ${placeKey(neighbour(place, 1))}`];
    case 'remove': {
      const next = removeAt(sequence, place);
      const near = [place, neighbour(place, -1)].find((each) => stepAt(next, each) !== undefined);
      return [next, '', near ? `remove ${placeKey(near)}` : 'undo'];
    }
  }
}
