import { useEffect, useState } from 'preact/hooks';
import type { Subject } from '../../words/index.ts';
import { useVocabulary } from './words.ts';

/** Code of the page that is loaded when it is first wanted, with the words it says. A module constant. */
export interface Code<C> {
  readonly words: readonly Subject[];
  readonly load: () => Promise<C>;
}

/** What has come, for those who want it later. */
const come = new WeakMap<object, unknown>();

/** Code for a control that stands already; `undefined` until it is wanted and has come. A whole part of the page is a `Slot`. */
export function useCode<C>(code: Code<C>, wanted: boolean): C | undefined {
  const vocabulary = useVocabulary();
  const [, setLoaded] = useState(false);
  const loaded = come.get(code) as C | undefined;
  useEffect(() => {
    if (!wanted || loaded !== undefined) return;
    Promise.all([code.load(), vocabulary.load(...code.words)]).then(([exports]) => {
      come.set(code, exports);
      setLoaded(true);
    }, reportError);
  }, [wanted]);
  return loaded;
}
