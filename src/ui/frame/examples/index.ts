import './shelf.css';

export { Shelf } from './shelf.tsx';
export { loadWords } from './shelf-words.ts';
export { SourceNote } from './source-note.tsx';
