import './values.css';
import { loadWords as loadSentences } from './language.ts';
import { typedValues } from './typed-values.ts';
import { valueAid } from './value-aid.ts';

export { Values } from './values.tsx';
export { WriteValues } from './write-values.tsx';

/** Loads the sentences, then lets values be typed into the fields of the form. */
export async function loadWords(): Promise<void> {
  await loadSentences();
  valueAid.value = typedValues;
}
