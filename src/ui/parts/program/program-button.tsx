import { useState } from 'preact/hooks';
import type { ProgramFor } from '../../../workbench/index.ts';
import { part, Slot } from '../slot.tsx';

const dialog = part(
  ['program'],
  () => import('./program-dialog.tsx'),
  ({ ProgramDialog }) => ProgramDialog,
);

interface ProgramButtonProps {
  readonly label: string;
  /** What the program is of, for its title. */
  readonly name: string;
  /** What the program is to be written for: asked for while it is shown. */
  readonly wanted: () => ProgramFor;
}

/** Opens the program of several frames or of a sequence, which have no tabs. */
export function ProgramButton({ label, name, wanted }: ProgramButtonProps) {
  const [open, setOpen] = useState(false);
  return (
    <>
      <button type="button" onClick={() => setOpen(true)}>
        {label}
      </button>
      {open && <Slot part={dialog} with={{ name, wanted: wanted(), onClose: () => setOpen(false) }} />}
    </>
  );
}
