import {
  builtInSequences,
  readSequences,
  type SequenceFileFault,
  type ShapeFault,
  writeSequences,
} from '../../sequences/index.ts';
import { bytesOfLink } from './sequence-frame.ts';
import type { SequenceLibrary } from './sequence-library.ts';

/** The largest file that is read, in bytes: sequences are small, so that a bigger file was chosen by mistake. */
export const LARGEST_SEQUENCES = 5_000_000;

/** What is said of an import. */
export interface SequenceImportWords {
  readonly unreadable: (file: string, fault: SequenceFileFault) => string;
  readonly emptyFile: string;
  readonly notTaken: (number: number, name: string, fault: ShapeFault) => string;
  readonly already: (name: string) => string;
  readonly imported: (name: string) => string;
  readonly renamed: (wanted: string, got: string) => string;
}

/** Adds the sequences of a file and chooses the last; a name that exists is changed. Returns the messages about it. */
export function importSequences(
  library: SequenceLibrary,
  text: string,
  file: string,
  words: SequenceImportWords,
): readonly string[] {
  const reading = readSequences(text, bytesOfLink);
  if (reading.kind === 'unreadable') return [words.unreadable(file, reading.fault)];
  if (reading.entries.length === 0) return [words.emptyFile];
  return reading.entries.flatMap((entry) => {
    if (entry.kind === 'faults') return entry.faults.map((fault) => words.notTaken(entry.number, entry.name, fault));
    const same = [...builtInSequences, ...library.own].find(
      (each) => writeSequences([each]) === writeSequences([entry.sequence]),
    );
    if (same) {
      library.choose(same.name);
      return [words.already(same.name)];
    }
    const wanted = entry.sequence.name;
    const got = library.add(entry.sequence);
    return [got === wanted ? words.imported(got) : words.renamed(wanted, got)];
  });
}
