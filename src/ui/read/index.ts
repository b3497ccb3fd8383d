import './read.css';
import { loadWords } from './language.ts';

export { BytesField } from './bytes-field.tsx';
export { loadWords };
