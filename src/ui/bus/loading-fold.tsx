import { Component, type ComponentType } from 'preact';
import { Slot } from '../parts/slot.tsx';

interface FoldedProps {
  readonly title: string;
  readonly load: () => Promise<ComponentType>;
}

/** A part of the view that is folded, and comes when it is first opened. */
export class Folded extends Component<FoldedProps, { readonly opened: boolean }> {
  override state = { opened: false };

  render() {
    const { title, load } = this.props;
    return (
      <details
        class="panel folded"
        onToggle={({ currentTarget }) => currentTarget.open && this.setState({ opened: true })}
      >
        <summary>
          <h2>{title}</h2>
        </summary>
        {this.state.opened && <Slot load={load} with={{}} />}
      </details>
    );
  }
}
