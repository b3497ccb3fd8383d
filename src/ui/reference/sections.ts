import type { ReferenceWords } from '../../words/index.ts';
import { numberingSection, unitSection } from './addresses.tsx';
import { exceptionSection, rangeSection } from './codes.tsx';
import type { Section } from './entry.tsx';
import { functionSection, meiSection, subFunctionSection } from './functions.tsx';
import { limitSection, sizeSection } from './limits.tsx';
import { misprintSection, openSection } from './notes.tsx';

/** All tables of the reference, in order. */
export const sectionsOf = (text: ReferenceWords): readonly Section[] => [
  functionSection(text),
  exceptionSection(text),
  subFunctionSection(text),
  meiSection(text),
  numberingSection(text),
  unitSection(text),
  sizeSection(text),
  limitSection(text),
  rangeSection(text),
  openSection(text),
  misprintSection(text),
];
