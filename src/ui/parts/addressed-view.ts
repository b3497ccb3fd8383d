import { Component } from 'preact';
import { type OtherView, partsAt, type ViewParts, viewAt } from '../../store/index.ts';
import { page } from './store.ts';

/**
 * A view beside the Frame view, whose state stands in its address, `#name?key=value`, as typed: a reload, a link and Back
 * find it as it was. Parts with an empty text are left out of the address.
 */
export abstract class AddressedView<P extends object, S extends object> extends Component<P, S> {
  /** What its address begins with. */
  protected abstract readonly name: OtherView;
  /** The title of the window while the view is open. */
  protected abstract readonly title: string;
  private stop: (() => void) | undefined;
  private titleBefore = '';

  /** What the view shows by the parts of its address. */
  protected abstract read(query: ReadonlyMap<string, string>): S;
  /** What of its state stands in its address. */
  protected abstract write(state: Readonly<S>): ViewParts;

  override componentWillMount() {
    this.setState(this.read(partsAt(page.address.given.value.hash)));
  }

  override componentDidMount() {
    this.titleBefore = document.title;
    document.title = this.title;
    const taken = page.address.given.value;
    this.stop = page.address.given.subscribe((given) => {
      if (given !== taken && viewAt(given.hash) === this.name) this.setState(this.read(partsAt(given.hash)));
    });
  }

  override componentWillUnmount() {
    this.stop?.();
    document.title = this.titleBefore;
    // A frame opened far down this view begins at its top.
    scrollTo(0, 0);
  }

  /** Changes what is shown while something is typed: the address follows at a pause. */
  protected change(state: Partial<S>): void {
    this.setState(state as S);
    page.follow(this.name, () => this.write(this.state));
  }

  /** Brings the address up to what is typed: at a pause, and before a link is followed, so that Back finds it. */
  protected readonly follow = (): void => page.address.now();
}
