import './read.css';

export { BytesField } from './bytes-field.tsx';
export { Findings } from './findings.tsx';
export { loadWords } from './language.ts';
export { ReadPanel } from './read-panel.tsx';
