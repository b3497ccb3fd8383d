import { Component, type ComponentChildren, type Ref } from 'preact';
import './fold.css';

interface FoldProps {
  readonly summary: ComponentChildren;
  /** The summary's name, if its text says too little. */
  readonly label?: string;
  readonly class?: string | undefined;
  readonly root?: Ref<HTMLDetailsElement> | undefined;
  /** Whether it is open at first. If `onToggle` changes it, it stays what the owner says. */
  readonly open?: boolean | undefined;
  readonly onToggle?: (open: boolean) => void;
  /** Whether what has been opened once stays while it is folded, so that what was typed in it is not lost. */
  readonly keep?: boolean;
  /** What it holds. A function makes it when it is opened; anything else is always there. */
  readonly children: ComponentChildren | (() => ComponentChildren);
}

interface FoldState {
  readonly open: boolean;
  readonly opened: boolean;
}

/** A part that is folded away until it is wanted. */
export class Fold extends Component<FoldProps, FoldState> {
  override state: FoldState = { open: this.props.open === true, opened: this.props.open === true };

  override componentWillReceiveProps({ open }: FoldProps) {
    if (open !== undefined && open !== this.props.open) this.setState({ open });
  }

  private readonly toggle = ({ currentTarget: { open } }: { readonly currentTarget: HTMLDetailsElement }) => {
    this.setState({ open, opened: true });
    if (open !== this.state.open) this.props.onToggle?.(open);
  };

  render() {
    const { summary, label, class: className, root = null, keep, children } = this.props;
    const { open, opened } = this.state;
    const held = typeof children !== 'function' ? children : (open || (keep && opened)) && children();
    return (
      <details ref={root} class={className} open={open} onToggle={this.toggle}>
        <summary aria-label={label}>{summary}</summary>
        {held}
      </details>
    );
  }
}

interface FoldPanelProps extends Omit<FoldProps, 'summary'> {
  readonly title: string;
  /** What stands beside the title: what the panel is for, or how much it holds. */
  readonly hint?: ComponentChildren;
}

/** A panel that is folded away until it is wanted. */
export const FoldPanel = ({ title, hint, class: name = '', ...fold }: FoldPanelProps) => (
  <Fold
    {...fold}
    class={`panel folded ${name}`}
    summary={
      <>
        <h2>{title}</h2> {hint !== undefined && <span class="said">{hint}</span>}
      </>
    }
  />
);
