import { Component, type ComponentChild } from 'preact';

/** The part of a list that a panel follows. */
interface Followed {
  followOtherTabs(onChange: () => void): () => void;
}

interface Focusing {
  /** What is to have the focus after the next drawing, by its `data-focus`: what had it may be gone. */
  readonly focus?: string | undefined;
}

/** A panel with a list kept in this browser. Typing in the frame's form draws none of it again. */
export abstract class KeptPanel<P, S extends Focusing> extends Component<P, S> {
  private stop: (() => void) | undefined;
  private drawn: readonly unknown[] = [];
  private root: HTMLElement | null = null;

  protected abstract readonly list: Followed;

  /** All that is shown beside the panel's own state. */
  protected abstract follows(): readonly unknown[];

  protected abstract view(): ComponentChild;

  /** After another tab has changed the list. */
  protected changedElsewhere(): void {}

  /** Takes the panel's own element. */
  protected readonly takeRoot = (root: HTMLElement | null): void => {
    this.root = root;
  };

  override componentDidMount() {
    this.stop = this.list.followOtherTabs(() => this.changedElsewhere());
  }

  override shouldComponentUpdate(_props: unknown, state: S) {
    return state !== this.state || this.follows().some((value, index) => value !== this.drawn[index]);
  }

  override componentWillUnmount() {
    this.stop?.();
  }

  override componentDidUpdate() {
    const { focus } = this.state;
    if (focus === undefined) return;
    this.setState({ focus: undefined });
    this.root?.querySelector<HTMLElement>(`[data-focus="${CSS.escape(focus)}"]`)?.focus();
  }

  render() {
    this.drawn = this.follows();
    return this.view();
  }
}
