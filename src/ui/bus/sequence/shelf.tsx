import { builtInSequences, readSequences, type SequenceTexts, writeSequences } from '../../../sequences/index.ts';
import { bytesOfLink } from '../../../workbench/index.ts';
import { download } from '../../saved/files.ts';
import { sequenceWords as words } from './language.ts';
import { library } from './library.ts';

/** A file of sequences is small; anything bigger is another file chosen by mistake. */
const LARGEST = 5_000_000;

interface ShelfProps {
  readonly sequence: SequenceTexts;
  readonly locked: boolean;
  readonly onSaid: (said: readonly string[]) => void;
}

/** The sequence as a file, and others from files. */
export function Shelf({ sequence, locked, onSaid }: ShelfProps) {
  const load = async (input: HTMLInputElement) => {
    const file = input.files?.[0];
    if (file === undefined) return;
    const text = file.size > LARGEST ? undefined : await file.text().catch(() => undefined);
    // The same file may be chosen again.
    input.value = '';
    onSaid(text === undefined ? [words.fileUnread(file.name)] : takeIn(text, file.name));
  };
  return (
    <>
      <button type="button" onClick={() => download(writeSequences([sequence]), words.fileName)}>
        {words.export}
      </button>
      <label class="file">
        {words.import}
        <input
          type="file"
          accept=".json,application/json"
          disabled={locked}
          onChange={({ currentTarget }) => void load(currentTarget)}
        />
      </label>
    </>
  );
}

/** Adds what a file has; what has a name that is taken gets another. Answers what is said of it. */
function takeIn(text: string, file: string): readonly string[] {
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
