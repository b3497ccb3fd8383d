import { Component, type ComponentChildren } from 'preact';
import { KeptChoice } from '../../store/index.ts';
import { flag } from '../../workbench/index.ts';
import { storage } from '../state/draft.ts';

interface FoldedProps {
  /** The name it is remembered by, and its class. */
  readonly name: string;
  readonly title: string;
  readonly hint: string;
  /** Whether the address has something in it, so that it is open at first whatever is remembered. */
  readonly filled?: boolean;
  /** What it holds: asked for while it is open only. */
  readonly children: () => ComponentChildren;
}

/** A part of the view that is folded away until it is wanted; whether it is open is remembered. */
export class Folded extends Component<FoldedProps, { readonly open: boolean }> {
  private readonly remembered = new KeptChoice(storage, this.props.name, false, flag);
  override state = { open: this.props.filled || this.remembered.value };

  render() {
    const { name, title, hint, children } = this.props;
    const { open } = this.state;
    return (
      <details
        class={`panel folded ${name}`}
        open={open}
        onToggle={({ currentTarget }) => {
          this.remembered.value = currentTarget.open;
          this.setState({ open: currentTarget.open });
        }}
      >
        <summary>
          <h2>{title}</h2> <span class="said">{hint}</span>
        </summary>
        {open && children()}
      </details>
    );
  }
}
