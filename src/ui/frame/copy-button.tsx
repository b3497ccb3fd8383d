import { Component } from 'preact';
import { formatBytes } from '../../notation/index.ts';
import { words } from '../language.ts';

const SHOWN = 4;

interface Said {
  readonly text: string;
  /** What was copied: said of other bytes it would be wrong. */
  readonly of: string;
}

/** Copies the frame as hexadecimal pairs. */
export class CopyButton extends Component<{ bytes: Uint8Array }, { said?: Said }> {
  private readonly copy = async () => {
    const of = formatBytes(this.props.bytes);
    const copied = navigator.clipboard?.writeText(of) ?? Promise.reject(new Error('no clipboard'));
    const text = await copied.then(
      () => words.page.copied,
      () => words.page.copyFailed,
    );
    this.setState({ said: { text, of } });
  };

  render() {
    const { bytes } = this.props;
    const { said } = this.state;
    const start = formatBytes(bytes.subarray(0, SHOWN));
    return (
      <p class="actions">
        <button type="button" class="first" onClick={this.copy}>
          {words.page.copy} <span class="mono">{start + (bytes.length > SHOWN ? '…' : '')}</span>
        </button>
        <output>{said?.of === formatBytes(bytes) ? said.text : ''}</output>
      </p>
    );
  }
}
