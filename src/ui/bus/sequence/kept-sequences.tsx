import { type SequenceTexts, writeSequences } from '../../../sequences/index.ts';
import { importSequences, LARGEST_SEQUENCES } from '../../../workbench/index.ts';
import { download } from '../../kit/download.ts';
import { FileButton } from '../../kit/file-button.tsx';
import { library } from './library.ts';
import { sequenceWords as words } from './sequence-words.ts';

interface ShelfProps {
  readonly sequence: SequenceTexts;
  readonly locked: boolean;
  readonly onSaid: (said: readonly string[]) => void;
}

/** The sequence as a file, and others from files. */
export function Shelf({ sequence, locked, onSaid }: ShelfProps) {
  const load = async (file: File) => {
    const text = file.size > LARGEST_SEQUENCES ? undefined : await file.text().catch(() => undefined);
    onSaid(text === undefined ? [words.fileUnread(file.name)] : importSequences(library, text, file.name, words));
  };
  return (
    <>
      <button type="button" onClick={() => download(writeSequences([sequence]), words.fileName)}>
        {words.export}
      </button>
      <FileButton
        label={words.import}
        accept=".json,application/json"
        disabled={locked}
        onFile={(file) => void load(file)}
      />
    </>
  );
}
