import { builtInSequences } from '../../../sequences/index.ts';
import { KeptChoice, StoredList } from '../../../store/index.ts';
import { SequenceLibrary, sequenceCodec, text } from '../../../workbench/index.ts';
import { storage } from '../../parts/store.ts';

const chosen = new KeptChoice(storage, 'sequence', builtInSequences[0]?.name ?? '', text(), 'tab');
const list = new StoredList(storage, 'sequences', sequenceCodec);

/** The sequences that are built in, and a person's own, which the browser keeps. */
export const library = new SequenceLibrary(list, chosen);

storage.follow(list.key, () => library.changedElsewhere());
