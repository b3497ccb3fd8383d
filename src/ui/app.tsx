import type { Vocabulary } from '../words/index.ts';
import { Words } from './parts/words.ts';
import { Views } from './views.tsx';

/** The page in a language, of which the words of the page have come. */
export const App = ({ vocabulary }: { readonly vocabulary: Vocabulary }) => (
  <Words.Provider value={vocabulary}>
    <Views />
  </Words.Provider>
);
