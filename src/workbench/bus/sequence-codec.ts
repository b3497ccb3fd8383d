import {
  builtInSequences,
  readSequences,
  type SequenceEntry,
  type SequenceFileFault,
  type SequenceTexts,
  writeSequences,
} from '../../sequences/index.ts';
import type { ListCodec } from '../kept-list.ts';
import { freeName } from '../names.ts';
import { bytesOfLink } from './sequence-frame.ts';

/** The largest file that is read, in bytes: sequences are small, so that a bigger file was chosen by mistake. */
export const LARGEST_SEQUENCES = 5_000_000;

/** A stored sequence that cannot be used, and why; it stays in the storage as it is. */
export type BadSequence = Extract<SequenceEntry, { readonly kind: 'faults' }>;

/** The names that are taken: those of the sequences that are built in, and of these. */
export const namesOfSequences = (sequences: readonly SequenceTexts[]) =>
  [...builtInSequences, ...sequences].map(({ name }) => name);

/** Sequences as the text of their file. */
export const sequenceCodec: ListCodec<SequenceTexts, SequenceFileFault, BadSequence> = {
  read(text) {
    const reading = readSequences(text, bytesOfLink);
    if (reading.kind === 'unreadable') return reading;
    const items: SequenceTexts[] = [];
    const bad: BadSequence[] = [];
    for (const entry of reading.entries) {
      if (entry.kind === 'faults') bad.push(entry);
      // A list that was edited by hand may have a name twice.
      else items.push({ ...entry.sequence, name: freeName(entry.sequence.name, new Set(namesOfSequences(items))) });
    }
    return { kind: 'list', items, bad };
  },
  write: (sequences, bad) =>
    writeSequences(
      sequences,
      bad.map(({ raw }) => raw),
    ),
};

/** Whether a sequence reads again as it is written. */
export function canBeKept(sequence: SequenceTexts): boolean {
  const reading = readSequences(writeSequences([sequence]), bytesOfLink);
  return reading.kind === 'sequences' && reading.entries[0]?.kind === 'sequence';
}
