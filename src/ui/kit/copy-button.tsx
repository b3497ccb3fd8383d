import { Component, type ComponentChildren } from 'preact';
import { putOnClipboard } from './clipboard.ts';

interface CopyingProps {
  /** What is said once a text is on the clipboard. */
  readonly copied: string;
  /** What is said if the browser refuses, of the text that was to be copied. */
  readonly refused: (text: string) => string;
  /** What the texts are of: what was said of one thing is not said of another. */
  readonly of: unknown;
  /** The buttons; `copy` makes the handler of one from what makes its text. */
  readonly children: (copy: (text: () => string) => () => void) => ComponentChildren;
}

interface CopyingState {
  readonly said: string;
  readonly of?: unknown;
}

/** Buttons that copy texts, and one place that says what became of it. */
export class Copying extends Component<CopyingProps, CopyingState> {
  override state: CopyingState = { said: '' };

  private async put(text: string): Promise<void> {
    const { copied, refused, of } = this.props;
    const said = (await putOnClipboard(text)) ? copied : refused(text);
    this.setState({ said, of });
  }

  private readonly copy = (text: () => string) => () => void this.put(text());

  render() {
    const { children, of } = this.props;
    return (
      <>
        {children(this.copy)} <output>{this.state.of === of ? this.state.said : ''}</output>
      </>
    );
  }
}

interface CopyButtonProps extends Omit<CopyingProps, 'children'> {
  readonly label: string;
  /** Its name for those who hear the page, if there are several: what it copies. */
  readonly name?: string;
  /** What is copied; made when the button is pressed. */
  readonly text: () => string;
}

/** A button that copies a text, and says beside it what became of it. */
export const CopyButton = ({ label, name, text, ...said }: CopyButtonProps) => (
  <span class="copy-button">
    <Copying {...said}>
      {(copy) => (
        <button type="button" aria-label={name} onClick={copy(text)}>
          {label}
        </button>
      )}
    </Copying>
  </span>
);
