import { useState } from 'preact/hooks';
import type { TraceView } from '../../../store/index.ts';
import type { ExportWanted } from '../../../workbench/index.ts';
import { useWords } from '../words.ts';
import { ExportDialog } from './export-dialog.tsx';

/** Opens what saves a trace; what was wanted last is wanted again. */
export function ExportButton({ of }: { readonly of: TraceView<File> }) {
  const words = useWords('trace').export;
  const [wanted, setWanted] = useState<ExportWanted>({ format: 'pcapng', replaced: {} });
  const [isOpen, setOpen] = useState(false);
  return (
    <>
      <button type="button" onClick={() => setOpen(true)}>
        {words.open}
      </button>
      {isOpen && <ExportDialog of={of} wanted={wanted} onWant={setWanted} onClose={() => setOpen(false)} />}
    </>
  );
}
