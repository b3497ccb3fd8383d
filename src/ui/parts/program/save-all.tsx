import { useState } from 'preact/hooks';
import type { Program } from '../../../codegen/index.ts';
import { allPrograms, type ProgramFor } from '../../../workbench/index.ts';
import { part, Slot } from '../slot.tsx';
import { useWords } from '../words.ts';
import { programs } from './program-store.ts';
import type { Zip } from './saved-zip.tsx';

const savedZip = part(
  [],
  () => import('./saved-zip.tsx'),
  ({ SavedZip }) => SavedZip,
);

interface SaveAllProps {
  readonly wanted: Extract<ProgramFor, { kind: 'subject' }>;
  readonly files: Program['files'];
  readonly target: string;
}

/** Saves the files of a target that has several as one, and the programs of all targets. */
export function SaveAll({ wanted, files, target }: SaveAllProps) {
  const words = useWords('program');
  const [zip, setZip] = useState<Zip>();
  const ofTarget = `${target}.zip`;
  return (
    <>
      {files.length > 1 && (
        <button
          type="button"
          onClick={() => setZip({ texts: files.map(({ name, text }) => ({ path: name, text })), name: ofTarget })}
        >
          {words.saveFile(ofTarget)}
        </button>
      )}
      <button
        type="button"
        onClick={() => setZip({ texts: allPrograms(wanted, programs.options.peek()), name: words.zipName })}
      >
        {words.saveAll}
      </button>
      {zip && <Slot part={savedZip} with={{ zip }} />}
    </>
  );
}
