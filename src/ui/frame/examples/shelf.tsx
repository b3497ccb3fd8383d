import { FoldPanel } from '../../kit/fold.tsx';
import { part, Slot } from '../../parts/slot.tsx';
import { useWords } from '../../parts/words.ts';
import { chosenExamples } from './chosen-example.ts';

const examples = part(
  ['examples'],
  () => import('./example-list.tsx'),
  ({ ExampleList }) => ExampleList,
);
const saved = part(
  ['saved'],
  () => import('../saved/saved-panel.tsx'),
  ({ SavedPanel }) => SavedPanel,
);
const savedCount = part(
  [],
  () => import('../saved/saved-panel.tsx'),
  ({ SavedCount }) => SavedCount,
);

/** Frames to begin with: those that manuals print, and those saved here. They are loaded when they are opened. */
export function Shelf() {
  const { panels } = useWords('page').page;
  return (
    <>
      <FoldPanel class="shelf" title={panels.examples.title}>
        {() => <Slot part={examples} with={{}} />}
      </FoldPanel>
      <FoldPanel class="shelf" keep title={panels.saved.title} hint={<Slot part={savedCount} with={{}} reserve={0} />}>
        {() => <Slot part={saved} with={{}} />}
      </FoldPanel>
    </>
  );
}

const note = part(
  ['examples'],
  () => import('./source-note.tsx'),
  ({ SourceNote }) => SourceNote,
);

/** The place for a note on the current frame if it is an example that was chosen. */
export const SourceNotePlace = () => (
  <div role="status">{chosenExamples.value.size > 0 && <Slot part={note} with={{}} />}</div>
);
