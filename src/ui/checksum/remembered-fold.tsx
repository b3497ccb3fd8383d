import { Component, type ComponentChildren } from 'preact';
import { KeptChoice } from '../../store/index.ts';
import { flag } from '../../workbench/index.ts';
import { FoldPanel } from '../kit/fold.tsx';
import { storage } from '../parts/store.ts';

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
export class Folded extends Component<FoldedProps> {
  private readonly remembered = new KeptChoice(storage, this.props.name, false, flag);
  private readonly open = this.props.filled || this.remembered.value;

  render() {
    const { name, title, hint, children } = this.props;
    return (
      <FoldPanel
        class={name}
        title={title}
        hint={hint}
        open={this.open}
        onToggle={(open) => {
          this.remembered.value = open;
        }}
      >
        {children}
      </FoldPanel>
    );
  }
}
