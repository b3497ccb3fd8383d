import { Component } from 'preact';
import { bus } from './bus.ts';

/** What changes often is drawn so often at most, in milliseconds. */
const EACH = 100;

/** A panel that is drawn again only when something changes that it shows: a line that is busy draws none of the others. */
export abstract class FollowingPanel<S = object> extends Component<object, S> {
  private stops: readonly (() => void)[] = [];
  private timer: ReturnType<typeof setTimeout> | undefined;
  private drawn: readonly unknown[] = [];

  /** All that is drawn and does not stand in the panel's own state. */
  protected abstract follows(): readonly unknown[];

  /** Listens to something besides the bus; answers how to stop. */
  protected abstract follow(look: () => void): () => void;

  override componentDidMount() {
    this.drawn = this.follows();
    this.stops = [bus.listen(this.look), this.follow(this.look)];
  }

  override componentDidUpdate() {
    this.drawn = this.follows();
  }

  override shouldComponentUpdate(_props: object, state: Readonly<S>) {
    return state !== this.state;
  }

  override componentWillUnmount() {
    for (const stop of this.stops) stop();
    clearTimeout(this.timer);
  }

  private readonly look = () => {
    this.timer ??= setTimeout(() => {
      this.timer = undefined;
      if (this.follows().some((value, index) => value !== this.drawn[index])) this.forceUpdate();
    }, EACH);
  };
}
