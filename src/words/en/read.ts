import type { Confidence } from '../../diagnosis/index.ts';
import { identify } from './identify.ts';
import { plural, sizeOf } from './numbers.ts';
import { pasting } from './pasting.ts';

const confidences: Readonly<Record<Confidence, string>> = {
  certain: 'Certain',
  likely: 'Likely',
  possible: 'Possible',
};

/** What is said where bytes are typed, pasted and read. */
export const read = {
  ...pasting,
  identity: identify.summary,
  confidences,
  text: 'Text to read',
  openFile: 'Open a file…',
  clear: 'Clear',
  beginning: (characters: number) => `The beginning of ${sizeOf(characters)}. All of it is read.`,
  failed:
    'The text could not be read: the browser ended what was reading it, perhaps because there was not enough memory. Paste a part of it.',
  reading: (characters: number) => `Reading ${sizeOf(characters)}…`,
  cancel: 'Cancel',
  frames: (count: number) => plural(count, 'frame'),
  found: (bytes: number, frames: number) => `${plural(bytes, 'byte')}, ${plural(frames, 'frame')}.`,
  line: (line: number, column: number) => `Line ${line}, column ${column}`,
  moreProblems: (count: number) => `and ${plural(count, 'more place')}`,
  inText: 'In the text',
  noFrameHere: 'no frame',
  whatElse: 'What it is',
  readSo: (what: string) => `Read as ${what}`,
  asIs: 'This reading is shown.',
  answers: (request: number) => `answers ${request}`,
  why: 'Why it fails',
  nothingWrong: 'What the frame says',
  showMe: 'Show me',
  useRepaired: 'Use the repaired frame',
};
