import { Dialog } from '../../kit/dialog.tsx';
import { useWords } from '../words.ts';
import { ProgramPanel, type ProgramPanelProps } from './program-panel.tsx';

interface ProgramDialogProps extends ProgramPanelProps {
  readonly name: string;
  readonly onClose: () => void;
}

/** The program of something that has no tabs: of several frames, or of a sequence. */
export function ProgramDialog({ name, onClose, ...panel }: ProgramDialogProps) {
  const words = useWords('program');
  return (
    <Dialog
      title={words.titleOf(name)}
      onClose={onClose}
      actions={
        <button type="button" onClick={onClose}>
          {words.close}
        </button>
      }
    >
      <ProgramPanel {...panel} />
    </Dialog>
  );
}
