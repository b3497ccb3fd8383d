import { Component, type ComponentType } from 'preact';
import type { Subject, Vocabulary } from '../../words/index.ts';
import { useWords, Words } from './words.ts';

/** A part of the page that is loaded when it is first shown, with the words it says. */
export interface Part<P> {
  readonly words: readonly Subject[];
  readonly load: () => Promise<ComponentType<P>>;
}

/** A part of a chunk, and the subjects of all the words that are said in it. */
export const part = <C, P>(
  words: readonly Subject[],
  chunk: () => Promise<C>,
  component: (chunk: C) => ComponentType<P>,
): Part<P> => ({ words, load: () => chunk().then(component) });

type Loader<P> = () => Promise<ComponentType<P>>;

interface SlotProps<P> {
  /** The part that stands here; asked for once for each place, and again where it did not come. */
  readonly part: Part<P> | Loader<P>;
  readonly with: P;
}

interface SlotState<P> {
  readonly View?: ComponentType<P>;
  /** How often the part did not come. */
  readonly failures: number;
}

/** What has come, so that it stands at once where it stands again. */
const come = new WeakMap<object, unknown>();

/** What asks again, of each place whose part did not come. */
const waiting = new Set<() => void>();

/** Where a part of the page stands as soon as it and its words have come. */
export class Slot<P extends object> extends Component<SlotProps<P>, SlotState<P>> {
  static override contextType = Words;
  override state: SlotState<P> = { failures: 0 };

  override componentWillMount() {
    const View = come.get(this.props.part) as ComponentType<P> | undefined;
    if (View) this.setState({ View });
  }

  override componentDidMount() {
    if (!this.state.View) this.fetch();
  }

  override componentWillUnmount() {
    waiting.delete(this.fetch);
  }

  private readonly fetch = (): void => {
    const { part } = this.props;
    const vocabulary: Vocabulary = this.context;
    const { load, words } = typeof part === 'function' ? { load: part, words: [] } : part;
    Promise.all([load(), vocabulary.load(...words)]).then(
      ([View]) => {
        come.set(part, View);
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
  const words = useWords('page').views;
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
