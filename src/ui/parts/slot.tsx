import { Component, type ComponentType } from 'preact';
import { views as words } from '../../words/index.ts';

interface SlotProps<P> {
  /** Brings the part that stands here; asked once for each place, and again where it did not come. */
  readonly load: () => Promise<ComponentType<P>>;
  readonly with: P;
}

interface SlotState<P> {
  readonly View?: ComponentType<P>;
  /** How often the part did not come. */
  readonly failures: number;
}

/** What has come, so that it stands at once where it stands again. */
const come = new WeakMap<() => Promise<unknown>, unknown>();

/** What asks again, of each place whose part did not come. */
const waiting = new Set<() => void>();

/** Where a part of the page stands as soon as it has come, right behind the first view. */
export class Slot<P extends object> extends Component<SlotProps<P>, SlotState<P>> {
  override state: SlotState<P> = { failures: 0 };

  override componentWillMount() {
    const View = come.get(this.props.load) as ComponentType<P> | undefined;
    if (View) this.setState({ View });
  }

  override componentDidMount() {
    if (!this.state.View) this.fetch();
  }

  override componentWillUnmount() {
    waiting.delete(this.fetch);
  }

  private readonly fetch = (): void => {
    const { load } = this.props;
    load().then(
      (View) => {
        come.set(load, View);
        waiting.delete(this.fetch);
        this.setState({ View });
      },
      (error) => {
        // A part that came and is faulty is not to be taken for one that did not come.
        reportError(error);
        waiting.add(this.fetch);
        this.setState(({ failures }) => ({ failures: failures + 1 }));
      },
    );
  };

  render() {
    const { View, failures } = this.state;
    if (View) return <View {...this.props.with} />;
    return failures > 0 && <Missing first={waiting.keys().next().value === this.fetch} again={failures > 1} />;
  }
}

/** Says that a part of the page did not come. The first of them is read out, and explains where asking again was no use. */
function Missing({ first, again }: { first: boolean; again: boolean }) {
  const explain = first && again;
  return (
    <div class="missing" role={first ? 'alert' : undefined}>
      <p class="error">
        {words.missing} {explain && words.missingWhy}
      </p>
      <button type="button" onClick={askAgain}>
        {words.tryAgain}
      </button>
      {explain && (
        <button type="button" onClick={() => location.reload()}>
          {words.reload}
        </button>
      )}
    </div>
  );
}

/** Asks for every part that did not come: what kept one of them away mostly kept others away too. */
function askAgain(): void {
  // The bundler's loader asks for each style once.
  for (const style of document.querySelectorAll<HTMLLinkElement>('link[rel=stylesheet]')) {
    if (!style.sheet) style.replaceWith(style.cloneNode());
  }
  for (const fetch of waiting) fetch();
}
