import { Component, createRef } from 'preact';

/** Out of sight, this many milliseconds pass before anything is drawn: typing draws what is seen and no more. */
const LATER = 100;

/** A part of the page that is drawn at once where it is in sight, and else at the next pause, or when it is seen. */
export abstract class DrawnWhenSeen<P, E extends Element, S = object> extends Component<P, S> {
  /** What is in sight or not: the part's own element. */
  protected readonly element = createRef<E>();
  private seen = true;
  private waiting: ReturnType<typeof setTimeout> | undefined;
  private readonly observer = new IntersectionObserver((entries) => {
    this.seen = entries.some(({ isIntersecting }) => isIntersecting);
    if (this.seen && this.waiting !== undefined) this.draw();
  });
  private readonly draw = () => this.forceUpdate();

  override shouldComponentUpdate() {
    if (this.seen) return true;
    clearTimeout(this.waiting);
    this.waiting = setTimeout(this.draw, LATER);
    return false;
  }

  override componentDidMount() {
    if (this.element.current) this.observer.observe(this.element.current);
  }

  override componentDidUpdate() {
    clearTimeout(this.waiting);
    this.waiting = undefined;
  }

  override componentWillUnmount() {
    clearTimeout(this.waiting);
    this.observer.disconnect();
  }
}
