import './values.css';

export { loadWords } from './language.ts';
export { Values } from './values.tsx';
export { WriteValues } from './write-values.tsx';
