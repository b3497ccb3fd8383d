import './values.css';
import { typedValues } from './typed-values.ts';
import { valueAid } from './value-aid.ts';
import { loadWords as loadSentences } from './value-words.ts';

export { Values } from './values.tsx';
export { WriteValues } from './write-values.tsx';

/** Loads the sentences, then lets values be typed into the fields of the form. */
export async function loadWords(): Promise<void> {
  await loadSentences();
  valueAid.value = typedValues;
}
