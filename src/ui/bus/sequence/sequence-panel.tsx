import { Component } from 'preact';
import type { LinkState } from '../../../bus/index.ts';
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
import { draft, evaluation } from '../../parts/store.ts';
import { bus } from '../bus.ts';
import { Head } from './head.tsx';
import { Shelf } from './kept-sequences.tsx';
import { library } from './library.ts';
import { run, type StepMark } from './run.ts';
import { RunBar } from './run-bar.tsx';
import { type StepAction, type StepDoings, StepList } from './sequence-steps.tsx';
import { sequenceWords as words } from './sequence-words.ts';

interface PanelState {
  readonly said: readonly string[];
  /** What is to have the focus after the next drawing: what had it may be gone. */
  readonly focus?: string | undefined;
  readonly link: LinkState['kind'];
}

const NO_MARKS: ReadonlyMap<string, StepMark> = new Map();

/** Frames, waits and conditions one after another: made, kept, and carried out. */
export class SequencePanel extends Component<object, PanelState> {
  override state: PanelState = { said: [], link: bus.state.link.kind };
  private stops: readonly (() => void)[] = [];
  private root: HTMLElement | null = null;

  override componentDidMount() {
    const draw = () => this.forceUpdate();
    this.stops = [
      library.listeners.add(draw),
      run.listeners.add(draw),
      // Of all that a busy line changes only this is shown here.
      bus.listen(({ link }) => link.kind !== this.state.link && this.setState({ link: link.kind })),
    ];
  }

  override componentWillUnmount() {
    for (const stop of this.stops) stop();
  }

  override shouldComponentUpdate(_props: object, state: PanelState) {
    return state !== this.state;
  }

  override componentDidUpdate() {
    const { focus } = this.state;
    if (focus === undefined) return;
    this.setState({ focus: undefined });
    this.root?.querySelector<HTMLElement>(`[data-focus="${CSS.escape(focus)}"]:not(:disabled)`)?.focus();
  }

  private readonly say = (said: readonly string[], focus?: string): void => this.setState({ said, focus });

  private readonly edit = (next: SequenceTexts, what = '', focus?: string): void => {
    const before = library.current;
    const builtIn = before && !library.isOwn(before);
    const name = library.edit(next, what);
    if (name === undefined) this.say([words.tooBig]);
    else this.say(builtIn ? [words.copied(name)] : [], focus);
  };

  private readonly doings: StepDoings = {
    change: (place, field, text) => {
      const { current } = library;
      if (current) this.edit(withField(current, place, field, text), `${placeKey(place)} ${field}`);
    },
    act: (place, action) => {
      const { current } = library;
      if (current) this.edit(...acted(current, place, action));
    },
    add: (place, what) => this.add(place, what),
  };

  private add(place: StepPlace, what: StepKind | 'frame'): void {
    const { current } = library;
    if (current === undefined) return;
    const { frame } = evaluation.value;
    const { kind, transport } = draft.value;
    if (what !== 'frame') this.edit(insertAt(current, place, newStep(what)));
    else if (frame === undefined || kind !== 'request' || transport !== current.transport)
      this.say([words.notAtHand(current.transport)]);
    else this.edit(insertAt(current, place, newStep('send', { bytes: formatBytes(frame.bytes) })));
  }

  render() {
    const sequence = run.active ? run.of : library.current;
    if (sequence === undefined) return null;
    const reading = readSequence(sequence);
    const faults = reading.kind === 'faults' ? reading.faults : [];
    // What came of a sequence says nothing of another.
    const ran = run.of === sequence;
    const marks = ran ? run.marks : NO_MARKS;
    return (
      <div
        class="sequence"
        ref={(root) => {
          this.root = root;
        }}
      >
        <p class="said">{words.intro}</p>
        {library.notKept && <p class="said error">{words.notKept[library.notKept]}</p>}
        {library.bad.length > 0 && (
          <div class="said error">
            <p>{words.badStored(library.bad.length)}</p>
            {library.bad.flatMap(({ number, name, faults }) =>
              faults.slice(0, 1).map((fault) => <p key={number}>{words.badEntry(number, name, fault)}</p>),
            )}
          </div>
        )}
        <Head sequence={sequence} locked={run.active} onEdit={this.edit} onSaid={this.say} />
        {listNames.map((list) => (
          <section key={list} aria-labelledby={`sequence-${list}`}>
            <h3 id={`sequence-${list}`}>{words.lists[list]}</h3>
            {sequence[list].length === 0 && <p class="said">{list === 'finally' ? words.noFinally : words.noSteps}</p>}
            <StepList
              sequence={sequence}
              steps={sequence[list]}
              place={{ list, at: [] }}
              faults={faults}
              marks={marks}
              doings={this.doings}
              locked={run.active}
            />
          </section>
        ))}
        <div role="status">
          {this.state.said.map((line) => (
            <p key={line}>{line}</p>
          ))}
        </div>
        <div class="actions">
          <button
            type="button"
            data-focus="undo"
            disabled={run.active || !library.canUndo}
            onClick={() => {
              library.undo();
              this.say([words.undone]);
            }}
          >
            {words.undo}
          </button>
          <Shelf sequence={sequence} onSaid={this.say} locked={run.active} />
        </div>
        <RunBar
          connected={this.state.link === 'open'}
          phase={ran || run.phase.kind === 'not-begun' ? run.phase : { kind: 'idle' }}
          faults={faults.length}
          onStart={() => reading.kind === 'sequence' && run.start(reading.sequence, sequence)}
        />
      </div>
    );
  }
}

/** The sequence after an action, under which it is undone, and where the focus is to be then. */
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
