import { type SequenceTexts, writeSequences } from '../../../sequences/index.ts';
import { importSequences, LARGEST_SEQUENCES } from '../../../workbench/index.ts';
import { download } from '../../kit/download.ts';
import { library } from './library.ts';
import { sequenceWords as words } from './sequence-words.ts';

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
    const text = file.size > LARGEST_SEQUENCES ? undefined : await file.text().catch(() => undefined);
    // The same file may be chosen again.
    input.value = '';
    onSaid(text === undefined ? [words.fileUnread(file.name)] : importSequences(library, text, file.name, words));
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
