import { comparePrinted, shownExample } from '../../../workbench/index.ts';
import { draft, evaluation } from '../../parts/store.ts';
import { useWords } from '../../parts/words.ts';
import { chosenExamples } from './chosen-example.ts';
import { PrintedBytes, reasonText } from './printed-bytes.tsx';
import './shelf.css';

/** What its source prints for the example that is shown, if that is wrong or incomplete. */
export function SourceNote() {
  const words = useWords('examples');
  const shown = shownExample(draft.value, evaluation.value.frame, chosenExamples.value);
  if (shown === undefined) return null;
  const { source, example } = shown;
  const comparison = comparePrinted(example);
  const { id, fault } = example;
  if (comparison.printed.length === comparison.right.length && fault === undefined) return null;
  return (
    <p class="source-note edged" data-severity={fault ? 'warning' : 'note'}>
      {comparison.printed.length === 0 ? (
        `${words.sources[source.id]}. ${words.noBytes}`
      ) : (
        <>
          {words.printedBy(source.id)} <PrintedBytes {...comparison} />
          {reasonText(example, comparison, words)} {fault === 'crc' && words.consequence} {words.more[id]}
        </>
      )}
    </p>
  );
}
