import { useState } from 'preact/hooks';
import { guideFaults, guideListing, writeProgram } from '../../../codegen/index.ts';
import type { WordsOf } from '../../../words/index.ts';
import { Dialog } from '../../kit/dialog.tsx';
import { useWords } from '../words.ts';
import { CodeView, type LineNote } from './code-view.tsx';
import { highlighting } from './languages.ts';
import './program.css';

/** The frame that the guide builds: 30 Hz for the drive with the address 6. */
const FRAME = {
  transport: 'rtu',
  direction: 'request',
  unitId: 6,
  functionCode: 6,
  fields: { address: 683, value: 4096 },
} as const;

const ST = highlighting('iecst', 'guide.st');

const notesOf = ({ listing }: WordsOf<'program'>): ReadonlyMap<number, LineNote> =>
  new Map(
    guideListing.flatMap(([, fault], index) => {
      if (fault === undefined) return [];
      const { refused, section } = guideFaults[fault];
      const note: LineNote = refused
        ? { text: listing.refused(fault, section), severity: 'error' }
        : { text: listing.compiles(fault), severity: 'warning' };
      return [[index + 1, note] as const];
    }),
  );

const theirs = (): string => guideListing.map(([line]) => line.trimEnd()).join('\n');

const ours = (): string =>
  writeProgram('structured-text', { request: FRAME }, { part: 'build', name: 'write' }).files[0]?.text ?? '';

/** The listing of a guide with what a strict compiler says of its lines, beside ours. */
export function GuideListing({ onClose }: { readonly onClose: () => void }) {
  const words = useWords('program');
  const { title, intro, theirs: printed, ours: written } = words.listing;
  return (
    <Dialog
      title={title}
      onClose={onClose}
      actions={
        <button type="button" onClick={onClose}>
          {words.close}
        </button>
      }
    >
      <p class="said">{intro}</p>
      <div class="program listings">
        <div>
          <h3>{printed}</h3>
          <CodeView label={printed} text={theirs()} highlighting={ST} notes={notesOf(words)} />
        </div>
        <div>
          <h3>{written}</h3>
          <CodeView label={written} text={ours()} highlighting={ST} />
        </div>
      </div>
    </Dialog>
  );
}

/** Opens it. */
export function GuideListingButton() {
  const { listing } = useWords('program');
  const [open, setOpen] = useState(false);
  return (
    <>
      <button type="button" onClick={() => setOpen(true)}>
        {listing.open}
      </button>
      {open && <GuideListing onClose={() => setOpen(false)} />}
    </>
  );
}
