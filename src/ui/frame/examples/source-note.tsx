import { comparePrinted } from '../../../workbench/index.ts';
import { exampleAtHand } from '../current-frame.ts';
import { PrintedBytes, reasonText } from './printed-bytes.tsx';
import { exampleWords as words } from './shelf-words.ts';

/** What the source of a chosen example prints, where that is not what is right. */
export function SourceNote() {
  return (
    <div role="status">
      <Note />
    </div>
  );
}

function Note() {
  const { source, example } = exampleAtHand() ?? {};
  if (source === undefined || example === undefined) return null;
  const comparison = comparePrinted(example);
  const { id, fault } = example;
  if (comparison.printed.length === comparison.right.length && fault === undefined) return null;
  return (
    <p class="source-note" data-severity={fault ? 'warning' : 'note'}>
      {comparison.printed.length === 0 ? (
        `${words.sources[source.id]}. ${words.noBytes}`
      ) : (
        <>
          {words.printedBy(source.id)} <PrintedBytes {...comparison} />
          {reasonText(example, comparison)} {fault === 'crc' && words.consequence} {words.more[id]}
        </>
      )}
    </p>
  );
}
