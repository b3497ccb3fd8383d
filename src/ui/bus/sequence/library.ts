import { builtInSequences } from '../../../sequences/index.ts';
import { KeptList, SequenceLibrary, sequenceCodec, text } from '../../../workbench/index.ts';
import { followStorage } from '../../state/browser-list.ts';
import { Remembered } from '../../state/remembered.ts';

const chosen = new Remembered('sequence', builtInSequences[0]?.name ?? '', text());
const list = new KeptList('sequences', sequenceCodec, () => localStorage);

/** The sequences that are built in, and a person's own, which the browser keeps. */
export const library = new SequenceLibrary(list, chosen);

/** Follows what other tabs store. Answers how to stop. */
export const followOtherTabs = (): (() => void) => followStorage(list, () => library.changedElsewhere());
