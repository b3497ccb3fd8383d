import type { Program } from '../../../codegen/index.ts';
import { allPrograms, type ProgramFor } from '../../../workbench/index.ts';
import { download } from '../../kit/download.ts';
import { useWords } from '../words.ts';
import { programs } from './program-store.ts';

interface SaveAllProps {
  readonly wanted: Extract<ProgramFor, { kind: 'subject' }>;
  readonly files: Program['files'];
  readonly target: string;
}

type Texts = readonly { readonly path: string; readonly text: string }[];

async function saveZip(texts: Texts, name: string): Promise<void> {
  const { zipOf } = await import('./zip.ts');
  download(zipOf(texts), name, 'application/zip');
}

/** Saves the files of a target that has several as one, and the programs of all targets. */
export function SaveAll({ wanted, files, target }: SaveAllProps) {
  const words = useWords('program');
  const zip = `${target}.zip`;
  return (
    <>
      {files.length > 1 && (
        <button
          type="button"
          onClick={() =>
            void saveZip(
              files.map(({ name, text }) => ({ path: name, text })),
              zip,
            )
          }
        >
          {words.saveFile(zip)}
        </button>
      )}
      <button type="button" onClick={() => void saveZip(allPrograms(wanted, programs.options.peek()), words.zipName)}>
        {words.saveAll}
      </button>
    </>
  );
}
