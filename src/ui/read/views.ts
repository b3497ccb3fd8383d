import './read.css';
import { takeIn } from './intake.ts';
import { restore } from './pasted.ts';

export { BytesField } from './bytes-field.tsx';
export { Findings } from './findings.tsx';
export { loadWords } from './language.ts';
export { ReadPanel } from './read-panel.tsx';

takeIn();
restore();
