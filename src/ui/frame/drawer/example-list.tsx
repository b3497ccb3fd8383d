import { formatBytes } from '../../../notation/index.ts';
import { comparePrinted, type Example, evaluate, exampleSources } from '../../../workbench/index.ts';
import { CopyButton } from '../../kit/copy-button.tsx';
import { part, Slot } from '../../parts/slot.tsx';
import { draft } from '../../parts/store.ts';
import { formatFor } from '../../parts/strip/copied-as.ts';
import { copiedAs } from '../../parts/strip/copied-text.ts';
import { useWords } from '../../parts/words.ts';
import { CopyTogether } from './copy-together.tsx';
import { PrintedBytes, reasonText } from './printed-bytes.tsx';
import { openKept } from './saved-frames.ts';

const listing = part(
  ['program'],
  () => import('../../parts/program/guide-listing.tsx'),
  ({ GuideListingButton }) => GuideListingButton,
);

/** Every example by its source, one click each. */
export function ExampleList() {
  const words = useWords('examples');
  const { copyAll, copyAllOf } = useWords('saved');
  return (
    <>
      <p class="said">{words.intro}</p>
      {exampleSources.map(({ id, examples }) => (
        <section key={id} aria-labelledby={`examples-${id}`}>
          <h3 id={`examples-${id}`}>{words.sources[id]}</h3>
          <CopyTogether
            frames={examples.map((example) => ({ name: words.names[example.id], draft: example.draft }))}
            label={copyAll(examples.length)}
            name={copyAllOf(examples.length, words.sources[id])}
          />
          {id === 'weg' && <Slot part={listing} with={{}} />}
          <ul class="kept-frames">
            {examples.map((example) => (
              <Item key={example.id} example={example} />
            ))}
          </ul>
        </section>
      ))}
    </>
  );
}

/** The frame of an example in the format copied last. */
function copiedText({ draft: of }: Example): string {
  const { frame } = evaluate(of);
  return frame === undefined ? '' : copiedAs(formatFor(frame.reading), frame);
}

function Item({ example }: { example: Example }) {
  const words = useWords('examples');
  const { drawer } = useWords('input');
  const { copied, copyFailed } = useWords('page').strip;
  const { id, fault } = example;
  const comparison = comparePrinted(example);
  const bytes = formatBytes(comparison.right);
  const name = words.names[id];
  return (
    <li aria-current={draft.value === example.draft || undefined}>
      <button
        type="button"
        class="open"
        data-row
        aria-describedby={`example-${id}`}
        onClick={() => openKept(example.draft)}
      >
        {name}
      </button>
      <CopyButton
        label={drawer.copy}
        name={drawer.copyOf(name)}
        text={() => copiedText(example)}
        of={id}
        copied={copied}
        refused={() => copyFailed}
      />
      <div id={`example-${id}`}>
        <p class="mono">{bytes}</p>
        <p class="said">{words.about[id]}</p>
        {comparison.printed.length === 0 && <p class="said">{words.noBytes}</p>}
        {fault && (
          <p class="said">
            {words.printed} <PrintedBytes {...comparison} />
          </p>
        )}
        {fault && (
          <details class="said">
            <summary>{words.why}</summary>
            {reasonText(example, comparison, words)} {fault === 'crc' && words.consequence} {words.more[id]}
          </details>
        )}
        {!fault && comparison.printed.length > 0 && comparison.printed.length < comparison.right.length && (
          <p class="said">{reasonText(example, comparison, words)}</p>
        )}
      </div>
    </li>
  );
}
