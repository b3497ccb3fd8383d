import { Component } from 'preact';

interface Focusing {
  /** What is to have the focus after the next drawing, by its `data-focus`: what had it may be gone. */
  readonly focus?: string | undefined;
}

/** A panel that says what has the focus after something in it is gone. */
export abstract class KeptPanel<P, S extends Focusing> extends Component<P, S> {
  private root: HTMLElement | null = null;

  /** Takes the panel's own element. */
  protected readonly takeRoot = (root: HTMLElement | null): void => {
    this.root = root;
  };

  override componentDidUpdate() {
    const { focus } = this.state;
    if (focus === undefined) return;
    this.setState({ focus: undefined });
    this.root?.querySelector<HTMLElement>(`[data-focus="${CSS.escape(focus)}"]`)?.focus();
  }
}
