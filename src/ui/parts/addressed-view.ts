import { Component } from 'preact';

/** Browsers limit how often the address may change, so that it follows typing at a little distance. */
const ADDRESS_DELAY = 250;

/**
 * A view beside the Frame view, whose state stands in its address, `#name?key=value`, as typed: a reload, a link and Back
 * find it as it was. Parts with an empty text are left out of the address.
 */
export abstract class AddressedView<P extends object, S extends object> extends Component<P, S> {
  /** What its address begins with. */
  protected abstract readonly name: string;
  /** The title of the window while the view is open. */
  protected abstract readonly title: string;
  private pending: ReturnType<typeof setTimeout> | undefined;
  private titleBefore = '';

  /** What the view shows by this address. */
  protected abstract read(query: URLSearchParams): S;
  /** What of its state stands in its address. */
  protected abstract write(state: Readonly<S>): Readonly<Record<string, string>>;

  override componentWillMount() {
    this.setState(this.read(query()));
  }

  override componentDidMount() {
    this.titleBefore = document.title;
    document.title = this.title;
    addEventListener('popstate', this.takeAddress);
    addEventListener('hashchange', this.takeAddress);
    addEventListener('pagehide', this.follow);
  }

  override componentWillUnmount() {
    this.drop();
    document.title = this.titleBefore;
    // A frame opened far down this view begins at its top.
    scrollTo(0, 0);
    removeEventListener('popstate', this.takeAddress);
    removeEventListener('hashchange', this.takeAddress);
    removeEventListener('pagehide', this.follow);
  }

  /** Changes what is shown while something is typed: the address follows at a pause. */
  protected change(state: Partial<S>): void {
    this.setState(state as S);
    clearTimeout(this.pending);
    this.pending = setTimeout(this.follow, ADDRESS_DELAY);
  }

  /** Brings the address up to what is typed: at a pause, and before a link is followed, so that Back finds it. */
  protected readonly follow = (): void => {
    if (this.pending === undefined) return;
    this.drop();
    const parts = Object.entries(this.write(this.state)).filter(([, text]) => text !== '');
    const address = `#${this.name}${parts.length > 0 ? `?${new URLSearchParams(parts)}` : ''}`;
    history.replaceState(null, '', address);
  };

  private readonly takeAddress = (): void => {
    this.drop();
    this.setState(this.read(query()));
  };

  private drop(): void {
    clearTimeout(this.pending);
    this.pending = undefined;
  }
}

/** What stands behind `?` in the address of a view. */
const query = () => new URLSearchParams(location.hash.split('?').slice(1).join('?'));
