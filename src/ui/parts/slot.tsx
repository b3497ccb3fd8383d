import type { ComponentType } from 'preact';
import { useEffect, useRef, useState } from 'preact/hooks';
import type { Subject } from '../../words/index.ts';
import { useVocabulary, useWords } from './words.ts';

/** A part of the page that is loaded when it is first shown, with the words it says. */
export interface Part<P> {
  readonly words: readonly Subject[];
  readonly load: () => Promise<ComponentType<P>>;
}

/** A part, whatever it is given. */
export interface Brought {
  readonly words: readonly Subject[];
  readonly load: () => Promise<unknown>;
}

/** A part of a chunk, and the subjects of all the words that are said in it. */
export const part = <C, P>(
  words: readonly Subject[],
  chunk: () => Promise<C>,
  component: (chunk: C) => ComponentType<P>,
): Part<P> => ({ words, load: () => chunk().then(component) });

interface SlotProps<P> {
  /** The part that stands here, a constant of its module: asked for once for each place, and again if it did not come. */
  readonly part: Part<P>;
  readonly with: P;
  /**
   * For a part that is fetched only when its place comes near what is in sight, or the page is touched: the height in pixels
   * that is kept free for it, so that nothing moves when it comes.
   */
  readonly reserve?: number;
}

/** A part is near if no more than this lies between its place and what is in sight. */
const NEAR = '200px 0px';

/** What has come, so that it stands at once where it stands again. */
const come = new WeakMap<object, unknown>();

/** Brings a part together with the part around it, which names its words too: it stands at once then. */
export async function bring(part: Brought): Promise<void> {
  come.set(part, await part.load());
}

/** What asks again, of each place whose part did not come. */
const waiting = new Set<() => void>();

/** Where a part of the page stands as soon as it and its words have come. */
export function Slot<P extends object>({ part, with: given, reserve }: SlotProps<P>) {
  const vocabulary = useVocabulary();
  const [View, setView] = useState(() => come.get(part) as ComponentType<P> | undefined);
  const [failed, setFailed] = useState<(() => void) | undefined>();
  const place = useRef<HTMLDivElement>(null);
  useEffect(() => {
    if (View) return;
    let gone = false;
    const fetch = () => {
      Promise.all([part.load(), vocabulary.load(...part.words)]).then(
        ([loaded]) => {
          come.set(part, loaded);
          waiting.delete(fetch);
          setView(() => loaded);
        },
        (error) => {
          if (!didNotCome(error)) reportError(error);
          // A place that is gone by now waits for nothing.
          if (gone) return;
          waiting.add(fetch);
          setFailed(() => fetch);
        },
      );
    };
    const stop = place.current ? whenNear(place.current, fetch) : fetch();
    return () => {
      stop?.();
      gone = true;
      waiting.delete(fetch);
    };
  }, []);
  if (View) return <View {...given} />;
  if (failed) return <Missing first={waiting.keys().next().value === failed} />;
  return reserve === undefined ? null : <div ref={place} style={{ minHeight: `${reserve}px` }} />;
}

/** Signs that somebody is there: what stands below is likely to be looked at soon. */
const TOUCHES = ['pointermove', 'pointerdown', 'keydown', 'focusin', 'scroll'];

/** Calls `act` once, when an element comes near what is in sight, or when the page is touched. Answers how to prevent that. */
function whenNear(element: Element, act: () => void): () => void {
  const done = new AbortController();
  const come = () => {
    done.abort();
    act();
  };
  const observer = new IntersectionObserver(
    (entries) => {
      if (entries.some(({ isIntersecting }) => isIntersecting)) come();
    },
    { rootMargin: NEAR },
  );
  done.signal.addEventListener('abort', () => observer.disconnect());
  observer.observe(element);
  for (const touch of TOUCHES) addEventListener(touch, come, { signal: done.signal });
  return () => done.abort();
}

/**
 * Whether a script or a style could not be fetched, which the browser has told already: in the words of the bundler's
 * loader, of Chromium and Firefox, or of Safari. Anything else is a fault in a part that came.
 */
const didNotCome = (error: unknown): boolean =>
  error instanceof Error &&
  /^Unable to preload CSS|dynamically imported module|^Importing a module script failed/.test(error.message);

/**
 * Says that a part of the page did not come. The first of them is read out, and offers a reload too: Firefox remembers a
 * script that failed, and does not ask for it again.
 */
function Missing({ first }: { first: boolean }) {
  const words = useWords('page').views;
  return (
    <div class="missing in-row" role={first ? 'alert' : undefined}>
      <p class="error">
        {words.missing} {first && words.missingWhy}
      </p>
      <button type="button" onClick={askAgain}>
        {words.tryAgain}
      </button>
      {first && (
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
