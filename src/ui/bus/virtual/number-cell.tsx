import { Component } from 'preact';
import { readNumber } from '../../../notation/index.ts';

interface NumberCellProps {
  /** Its name; shown only where `shown` is. */
  readonly label: string;
  readonly shown?: boolean;
  readonly value: number;
  readonly least: number;
  readonly most: number;
  /** What is said of anything else. */
  readonly wrong: string;
  readonly onChange: (value: number) => void;
}

/**
 * A number that is taken when it has been typed to its end. Until then, and while it cannot be read, the text stays and
 * what comes in the meantime does not disturb it; Escape gives it up.
 */
export class NumberCell extends Component<
  NumberCellProps,
  { readonly text: string | undefined; readonly wrong: boolean }
> {
  override state = { text: undefined as string | undefined, wrong: false };

  private readonly take = () => {
    const { text } = this.state;
    const { least, most, onChange } = this.props;
    if (text === undefined) return;
    const value = readNumber(text);
    if (value === undefined || !Number.isInteger(value) || value < least || value > most) {
      this.setState({ wrong: true });
      return;
    }
    this.setState({ text: undefined, wrong: false });
    onChange(value);
  };

  private readonly key = ({ key }: KeyboardEvent) => {
    if (key === 'Enter') this.take();
    if (key === 'Escape') this.setState({ text: undefined, wrong: false });
  };

  render() {
    const { label, shown, value, wrong: said } = this.props;
    const { text, wrong } = this.state;
    const id = `virtual-${label.toLowerCase().replaceAll(/[^a-z0-9]+/g, '-')}`;
    return (
      <div class="number-cell" data-invalid={wrong ? '' : undefined}>
        {shown && <label for={id}>{label}</label>}
        <input
          id={id}
          class="mono"
          aria-label={shown ? undefined : label}
          autocomplete="off"
          spellcheck={false}
          value={text ?? String(value)}
          aria-invalid={wrong}
          aria-describedby={wrong ? `${id}-said` : undefined}
          onInput={({ currentTarget }) => this.setState({ text: currentTarget.value, wrong: false })}
          onBlur={this.take}
          onKeyDown={this.key}
        />
        {wrong && (
          <p class="said" id={`${id}-said`} role="alert">
            <span class="error">{said}</span>
          </p>
        )}
      </div>
    );
  }
}
