import { disabledFor } from './disabled-for.ts';
import './file-button.css';

interface FileButtonProps {
  readonly label: string;
  /** The endings and types that are offered, as `accept` of an input has them. */
  readonly accept?: string;
  /** Why no file can be chosen now. */
  readonly disabledFor?: string | undefined;
  readonly onFile: (file: File) => void;
}

/** A button that asks for a file. The same file may be chosen again. */
export const FileButton = ({ label, accept, disabledFor: why, onFile }: FileButtonProps) => (
  <label class="file">
    {label}
    <input
      type="file"
      accept={accept}
      {...disabledFor(why)}
      onChange={({ currentTarget }) => {
        const file = currentTarget.files?.[0];
        currentTarget.value = '';
        if (file) onFile(file);
      }}
    />
  </label>
);
