import type { ComponentType } from 'preact';
import { useEffect, useErrorBoundary, useState } from 'preact/hooks';
import type { Subject } from '../../words/index.ts';
import { useVocabulary, useWords } from './words.ts';

/** Code of the page that is loaded when it is first wanted, with the words it says. A constant of its module. */
export interface Code<C> {
  readonly words: readonly Subject[];
  readonly load: () => Promise<C>;
}

/** A part of the page that is loaded when it is first shown. */
export type Part<P> = Code<ComponentType<P>>;

/** A part, whatever it is given. */
export type Brought = Code<unknown>;

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
}

/** What has come, so that it stands at once where it stands again. */
const come = new WeakMap<object, unknown>();

/** Brings code, and its words unless those around it bring them: it stands at once then. */
export async function bring(code: Brought, words?: Promise<void>): Promise<void> {
  const [loaded] = await Promise.all([code.load(), words]);
  if (isEmpty(loaded)) throw new TypeError('The imported module is empty.');
  come.set(code, loaded);
}

/** A server may answer with an empty file, which is a module without exports. */
const isEmpty = (loaded: unknown): boolean =>
  loaded === undefined || (typeof loaded === 'object' && loaded !== null && Object.keys(loaded).length === 0);

/** Code for a control that stands already, or for a part that is to come at once later; `undefined` until it is wanted and has come. */
export function useCode<C>(code: Code<C>, wanted: boolean): C | undefined {
  const vocabulary = useVocabulary();
  const [, setLoaded] = useState(false);
  const loaded = come.get(code) as C | undefined;
  useEffect(() => {
    if (!wanted || loaded !== undefined) return;
    bring(code, vocabulary.load(...code.words)).then(
      () => setLoaded(true),
      (error) => didNotCome(error) || reportError(error),
    );
  }, [wanted]);
  return loaded;
}

/** What asks again, of each place whose part did not come. */
const waiting = new Set<() => void>();

/** Where a part of the page stands as soon as it and its words have come. What fails in it does so here alone, and is said. */
export function Slot<P extends object>({ part, with: given }: SlotProps<P>) {
  const [fault, forget] = useErrorBoundary((error) => reportError(error));
  const vocabulary = useVocabulary();
  const [View, setView] = useState(() => come.get(part) as ComponentType<P> | undefined);
  const [failed, setFailed] = useState<(() => void) | undefined>();
  useEffect(() => {
    if (View) return;
    let gone = false;
    const fetch = () => {
      bring(part, vocabulary.load(...part.words)).then(
        () => {
          waiting.delete(fetch);
          setView(() => come.get(part) as ComponentType<P>);
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
    fetch();
    return () => {
      gone = true;
      waiting.delete(fetch);
    };
  }, []);
  if (fault !== undefined) return <NotThere fault={fault} first again={forget} />;
  if (View) return <View {...given} />;
  if (failed) return <NotThere first={waiting.keys().next().value === failed} again={askAgain} />;
  return null;
}

/**
 * Whether a script or a style could not be fetched, which the browser has told already, or is empty: in the words of the
 * bundler's loader, of Chromium and Firefox and here, or of Safari. Anything else is a fault in a part that came.
 */
const didNotCome = (error: unknown): boolean => /preload CSS|imported module|a module script/.test(`${error}`);

interface NotThereProps {
  /** What the part threw; `undefined` if it did not come. */
  readonly fault?: unknown;
  readonly first: boolean;
  readonly again: () => void;
}

/**
 * Says that a part of the page did not come, or has failed. The first of them is read out, and offers a reload too: Firefox
 * remembers a script that failed, and does not ask for it again.
 */
function NotThere({ fault, first, again }: NotThereProps) {
  const words = useWords('page').views;
  return (
    <div class="missing in-row" role={first ? 'alert' : undefined}>
      <p class="error">
        {fault === undefined ? words.missing : words.failed(`${fault}`)}{' '}
        {fault === undefined && first && words.missingWhy}
      </p>
      <button type="button" onClick={again}>
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
  // The bundler's loader asks for each style once. One that did not come has no rules, or they cannot be read.
  for (const style of document.querySelectorAll<HTMLLinkElement>('link[rel=stylesheet]')) {
    try {
      if (style.sheet?.cssRules.length) continue;
    } catch {}
    style.replaceWith(style.cloneNode());
  }
  for (const fetch of waiting) fetch();
}
