import './shelf.css';

export { loadWords } from './language.ts';
export { Shelf } from './shelf.tsx';
export { SourceNote } from './source-note.tsx';
