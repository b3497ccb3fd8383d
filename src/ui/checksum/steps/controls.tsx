import { Component } from 'preact';
import type { StepPlace } from '../../../workbench/index.ts';
import { readStepPlace } from '../../../workbench/index.ts';
import { Select } from '../../kit/choice.tsx';
import { type Speed, speeds } from './player.ts';
import { stepWords as words } from './step-words.ts';

/** What the buttons and the keys do. */
export interface Moves {
  readonly first: () => void;
  readonly back: () => void;
  readonly play: () => void;
  readonly forward: () => void;
  readonly last: () => void;
  readonly foldAll: () => void;
  readonly unfoldAll: () => void;
}

interface ControlsProps {
  readonly bytes: number;
  readonly moves: Moves;
  readonly playing: boolean;
  readonly atFirst: boolean;
  readonly atLast: boolean;
  readonly speed: Speed;
  readonly onSpeed: (speed: Speed) => void;
  readonly onGo: (place: StepPlace) => void;
}

/** The id of the field that leads to a byte. */
export const GO_TO = 'steps-go-to';

/** The buttons above the steps. */
export function Controls({ bytes, moves, playing, atFirst, atLast, speed, onSpeed, onGo }: ControlsProps) {
  // A button that is disabled under the finger loses the focus, so that it only says so.
  const button = (label: string, act: () => void, idle = false) => (
    <button type="button" aria-disabled={idle || undefined} onClick={act}>
      {label}
    </button>
  );
  return (
    <div class="step-controls">
      <div class="group">
        {button(words.first, moves.first, atFirst)}
        {button(words.back, moves.back, atFirst)}
        {button(playing ? words.stop : words.play, moves.play, atLast && !playing)}
        {button(words.forward, moves.forward, atLast)}
        {button(words.last, moves.last, atLast)}
      </div>
      <label>
        {words.speed}{' '}
        <Select
          value={speed}
          options={speeds.map((value) => ({ value, name: words.perSecond(value) }))}
          onChoose={onSpeed}
        />
      </label>
      <div class="group">
        {button(words.foldAll, moves.foldAll)}
        {button(words.unfoldAll, moves.unfoldAll)}
      </div>
      <GoTo bytes={bytes} onGo={onGo} />
    </div>
  );
}

interface GoToProps {
  readonly bytes: number;
  readonly onGo: (place: StepPlace) => void;
}

/** Leads to a byte, or to a shift of it. */
class GoTo extends Component<GoToProps, { readonly text: string; readonly wrong: boolean }> {
  override state = { text: '', wrong: false };

  private readonly go = (event: Event) => {
    event.preventDefault();
    const place = readStepPlace(this.state.text, this.props.bytes);
    this.setState({ wrong: place === undefined });
    if (place) this.props.onGo(place);
  };

  render() {
    const { text } = this.state;
    const { bytes } = this.props;
    const wrong = this.state.wrong && readStepPlace(text, bytes) === undefined;
    return (
      <form class="go-to" data-invalid={wrong ? '' : undefined} onSubmit={this.go}>
        <label for={GO_TO}>{words.goTo}</label>
        <input
          id={GO_TO}
          class="mono"
          autocomplete="off"
          spellcheck={false}
          placeholder={words.goToHint}
          aria-invalid={wrong}
          aria-describedby={`${GO_TO}-said`}
          value={text}
          onInput={({ currentTarget }) => this.setState({ text: currentTarget.value, wrong: false })}
        />
        <button type="submit">{words.go}</button>
        <output id={`${GO_TO}-said`} for={GO_TO} class="error">
          {wrong ? words.noSuchByte(bytes - 1) : ''}
        </output>
      </form>
    );
  }
}
