import './shelf.css';
import { loadWords } from './language.ts';
import { Shelf } from './shelf.tsx';
import { SourceNote } from './source-note.tsx';

/** What the shelf shows, as soon as its sentences are there too. */
export async function loadViews() {
  await loadWords();
  return { Shelf, SourceNote };
}
