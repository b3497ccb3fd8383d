import { Component } from 'preact';
import type { CrcSteps } from '../../../modbus/index.ts';
import { dictionary } from '../../../modbus/index.ts';
import { KeptChoice } from '../../../store/index.ts';
import { flag, type StepPlace, StepRows, stepsText, stepText } from '../../../workbench/index.ts';
import { CopyButton } from '../../kit/copy-button.tsx';
import { storage } from '../../parts/store.ts';
import { AfterPaint } from './after-paint.ts';
import { ByTable } from './by-table.tsx';
import { Controls, GO_TO, type Moves } from './controls.tsx';
import { EntriesPanel } from './entries-panel.tsx';
import { KeyHelp } from './key-help.tsx';
import { Player } from './player.ts';
import { Receiver } from './receiver.tsx';
import { Result } from './result.tsx';
import { StepList } from './step-list.tsx';
import { stepWords as words } from './step-words.ts';

const startsFolded = new KeptChoice(storage, 'checksum-steps-folded', false, flag);

/** Registers of more bits take the whole width. */
const WIDE = 18;

/** The id of the names of the keys. */
const KEYS = 'steps-keys';

interface StepperProps {
  readonly steps: CrcSteps;
}

interface StepperState {
  readonly steps: CrcSteps;
  readonly rows: StepRows;
  readonly place: StepPlace;
}

/** Goes through the steps: with buttons, with keys, and by itself. */
export class Stepper extends Component<StepperProps, StepperState> {
  private readonly player = new Player(() => this.advance());

  override state = begin(this.props.steps);

  /** Other bytes start from the beginning: the place may no longer exist. */
  static override getDerivedStateFromProps({ steps }: StepperProps, state: StepperState): Partial<StepperState> | null {
    return state.steps === steps ? null : begin(steps);
  }

  override componentDidUpdate({ steps }: StepperProps) {
    if (steps !== this.props.steps) this.pause();
  }

  override componentWillUnmount() {
    this.player.stop();
  }

  private get row(): number {
    return this.state.rows.row(this.state.place);
  }

  private readonly choose = (row: number) => {
    const { rows } = this.state;
    this.setState({ place: rows.place(Math.max(0, Math.min(rows.length - 1, row))) });
  };

  private readonly move = (by: number) => {
    this.player.stop();
    this.choose(this.row + by);
  };

  private readonly pause = () => {
    this.player.stop();
    this.forceUpdate();
  };

  private advance(): void {
    if (this.row >= this.state.rows.length - 1) this.pause();
    else this.choose(this.row + 1);
  }

  /** Folds or unfolds a byte, and goes to it. */
  private readonly toggle = (at: number) => {
    const { rows } = this.state;
    this.fold((each) => rows.open(each) !== (each === at), { at, shift: 0 });
  };

  private fold(isOpen: (at: number) => boolean, { at, shift }: StepPlace): void {
    const rows = new StepRows(this.props.steps.bytes.length, isOpen);
    // A shift that is folded away is at its byte.
    this.setState({ rows, place: { at, shift: rows.open(at) ? shift : 0 } });
  }

  private foldAll(folded: boolean): void {
    startsFolded.value = folded;
    this.fold(() => !folded, this.state.place);
  }

  private readonly go = (place: StepPlace) => {
    this.player.stop();
    const { rows } = this.state;
    if (place.shift > 0 && !rows.open(place.at)) this.toggle(place.at);
    this.setState({ place });
  };

  private readonly moves: Moves = {
    first: () => this.move(-Infinity),
    back: () => this.move(-1),
    play: () => {
      if (this.player.playing) this.player.stop();
      else if (this.row < this.state.rows.length - 1) this.player.play();
      this.forceUpdate();
    },
    forward: () => this.move(1),
    last: () => this.move(Infinity),
    foldAll: () => this.foldAll(true),
    unfoldAll: () => this.foldAll(false),
  };

  private readonly keys: Readonly<Record<string, () => void>> = dictionary({
    ArrowDown: this.moves.forward,
    ArrowUp: this.moves.back,
    ArrowRight: () => this.unfold(),
    ArrowLeft: () => this.leave(),
    'Shift ArrowRight': this.moves.unfoldAll,
    'Shift ArrowLeft': this.moves.foldAll,
    PageDown: () => this.toByte(this.state.place.at + 1),
    PageUp: () => this.toByte(this.state.place.at - (this.state.place.shift === 0 ? 1 : 0)),
    Home: this.moves.first,
    End: this.moves.last,
    ' ': this.moves.play,
    '+': () => this.faster(1),
    'Shift +': () => this.faster(1),
    '-': () => this.faster(-1),
    g: () => document.getElementById(GO_TO)?.focus(),
  });

  private readonly onKey = (event: KeyboardEvent) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const act = this.keys[`${event.shiftKey ? 'Shift ' : ''}${event.key}`];
    if (!act) return;
    event.preventDefault();
    act();
  };

  private toByte(at: number): void {
    this.go({ at: Math.max(0, Math.min(this.props.steps.bytes.length - 1, at)), shift: 0 });
  }

  /** Unfolds a byte; where it is unfolded, goes into it, as in any tree. */
  private unfold(): void {
    const { rows, place } = this.state;
    if (!rows.open(place.at)) this.toggle(place.at);
    else if (place.shift === 0) this.move(1);
  }

  /** Leaves the shifts for their byte; there, folds it. */
  private leave(): void {
    const { rows, place } = this.state;
    if (place.shift > 0) this.go({ at: place.at, shift: 0 });
    else if (rows.open(place.at)) this.toggle(place.at);
  }

  private faster(by: 1 | -1): void {
    this.player.faster(by);
    this.forceUpdate();
  }

  render() {
    const { steps } = this.props;
    const { rows, place } = this.state;
    return (
      <>
        <Controls
          bytes={steps.bytes.length}
          moves={this.moves}
          playing={this.player.playing}
          atFirst={this.row === 0}
          atLast={this.row === rows.length - 1}
          speed={this.player.speed}
          onSpeed={(speed) => {
            this.player.speed = speed;
            this.forceUpdate();
          }}
          onGo={this.go}
        />
        <div class="step-columns" data-wide={steps.form.bits > WIDE ? '' : undefined}>
          <div class="step-by-step">
            <StepList
              steps={steps}
              rows={rows}
              chosen={this.row}
              describedBy={KEYS}
              onChoose={(row) => this.move(row - this.row)}
              onFold={this.toggle}
              onKey={this.onKey}
            />
            <p class="now">{stepText(steps, place, words)}</p>
            <CopyButton
              label={words.copySteps}
              text={() => stepsText(steps, rows, words)}
              of={rows}
              copied={words.copied}
              refused={() => words.copyFailed}
            />
            <KeyHelp id={KEYS} />
          </div>
          <AfterPaint>
            {() => (
              <>
                <ByTable steps={steps} place={place} />
                <div class="step-end">
                  <Result steps={steps} />
                  <Receiver steps={steps} />
                </div>
              </>
            )}
          </AfterPaint>
        </div>
        <EntriesPanel steps={steps} index={steps.byte(place.at).index} />
      </>
    );
  }
}

function begin(steps: CrcSteps): StepperState {
  const folded = startsFolded.value;
  return { steps, rows: new StepRows(steps.bytes.length, () => !folded), place: { at: 0, shift: 0 } };
}
