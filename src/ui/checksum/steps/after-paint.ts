import { Component, type ComponentChildren } from 'preact';

interface AfterPaintProps {
  readonly children: () => ComponentChildren;
}

/** What is drawn when all before it is on the screen: opening a view need not wait for it. */
export class AfterPaint extends Component<AfterPaintProps, { readonly ready: boolean }> {
  override state = { ready: false };
  private frame = 0;
  private timer: ReturnType<typeof setTimeout> | undefined;

  override componentDidMount() {
    this.frame = requestAnimationFrame(() => {
      this.timer = setTimeout(() => this.setState({ ready: true }));
    });
  }

  override componentWillUnmount() {
    cancelAnimationFrame(this.frame);
    clearTimeout(this.timer);
  }

  render() {
    return this.state.ready ? this.props.children() : null;
  }
}
