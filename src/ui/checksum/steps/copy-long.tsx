import { Component } from 'preact';
import { stepWords as words } from './step-words.ts';

interface CopyProps {
  readonly label: string;
  /** What is copied: made when it is asked for. */
  readonly text: () => string;
  /** What the text is of: said of anything else, “copied” would be wrong. */
  readonly of: unknown;
}

interface CopyState {
  readonly said: string;
  readonly of?: unknown;
}

/** Copies a long text: where the browser refuses, it says so, but not the text, as that of a value would be. */
export class CopyLong extends Component<CopyProps, CopyState> {
  override state: CopyState = { said: '' };

  private readonly copy = async () => {
    const { text, of } = this.props;
    const copied = navigator.clipboard?.writeText(text()) ?? Promise.reject(new Error('no clipboard'));
    const said = await copied.then(
      () => words.copied,
      () => words.copyFailed,
    );
    this.setState({ said, of });
  };

  render() {
    const { label, of } = this.props;
    return (
      <span class="copy-steps">
        <button type="button" onClick={() => void this.copy()}>
          {label}
        </button>{' '}
        <output>{this.state.of === of ? this.state.said : ''}</output>
      </span>
    );
  }
}
