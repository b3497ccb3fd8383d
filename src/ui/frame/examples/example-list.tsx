import { formatBytes } from '../../../notation/index.ts';
import { comparePrinted, type Example, exampleSources } from '../../../workbench/index.ts';
import { FoldPanel } from '../../kit/fold.tsx';
import { choose } from '../current-frame.ts';
import { PrintedBytes, reasonText } from './printed-bytes.tsx';
import { exampleWords as words } from './shelf-words.ts';

/** Every example by its source, one click each. */
export function ExampleList() {
  return (
    <FoldPanel title={words.title}>
      <p class="said">{words.intro}</p>
      <div class="sources">
        {exampleSources.map(({ id, examples }) => (
          <section key={id} aria-labelledby={`examples-${id}`}>
            <h3 id={`examples-${id}`}>{words.sources[id]}</h3>
            <ul class="examples">
              {examples.map((example) => (
                <Item key={example.id} example={example} />
              ))}
            </ul>
          </section>
        ))}
      </div>
    </FoldPanel>
  );
}

function Item({ example }: { example: Example }) {
  const { id, fault } = example;
  const comparison = comparePrinted(example);
  return (
    <li>
      <button type="button" aria-describedby={`example-${id}`} onClick={() => choose(example)}>
        {words.names[id]}
      </button>
      <div id={`example-${id}`}>
        <p class="mono">{formatBytes(comparison.right)}</p>
        <p class="said">{words.about[id]}</p>
        {fault && (
          <p class="said">
            {words.printed} <PrintedBytes {...comparison} />
            {reasonText(example, comparison)}
          </p>
        )}
      </div>
    </li>
  );
}
