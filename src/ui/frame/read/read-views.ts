import './read.css';
import { restore } from '../../parts/pasted.ts';
import { takeIn } from './intake.ts';

export { BytesField } from './bytes-field.tsx';
export { FindingsPlace } from './findings-place.tsx';
export { ReadPanel } from './read-panel.tsx';
export { loadWords } from './read-words.ts';

takeIn();
restore();
