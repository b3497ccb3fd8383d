import { type SequenceTexts, writeSequences } from '../../../sequences/index.ts';
import type { SequenceImport } from '../../../store/index.ts';
import type { WordsOf } from '../../../words/index.ts';
import { LARGEST_SEQUENCES } from '../../../workbench/index.ts';
import { download } from '../../kit/download.ts';
import { FileButton } from '../../kit/file-button.tsx';
import { useWords } from '../../parts/words.ts';
import { sequences } from '../jobs.ts';

interface FilesProps {
  readonly sequence: SequenceTexts;
  readonly locked: boolean;
  readonly onMessage: (lines: readonly string[]) => void;
}

/** The sequence as a file, and others from files. */
export function SequenceFiles({ sequence, locked, onMessage }: FilesProps) {
  const words = useWords('sequence');
  const load = async (file: File) => {
    const text = file.size > LARGEST_SEQUENCES ? undefined : await file.text().catch(() => undefined);
    onMessage(
      text === undefined ? [words.fileUnread(file.name)] : importMessages(sequences.import(text), file.name, words),
    );
  };
  return (
    <>
      <button type="button" onClick={() => download(writeSequences([sequence]), words.fileName)}>
        {words.export}
      </button>
      <FileButton
        label={words.import}
        accept=".json,application/json"
        disabledFor={locked ? words.locked : undefined}
        onFile={(file) => void load(file)}
      />
    </>
  );
}

/** What became of a file, one line for each thing. */
function importMessages(result: SequenceImport, file: string, words: WordsOf<'sequence'>): readonly string[] {
  if (result.kind === 'unreadable') return [words.unreadable(file, result.fault)];
  if (result.entries.length === 0) return [words.emptyFile];
  return result.entries.flatMap((entry) => {
    if ('faults' in entry) return entry.faults.map((fault) => words.notTaken(entry.number, entry.name, fault));
    if ('already' in entry) return [words.already(entry.already)];
    return [entry.got === entry.wanted ? words.imported(entry.got) : words.renamed(entry.wanted, entry.got)];
  });
}
