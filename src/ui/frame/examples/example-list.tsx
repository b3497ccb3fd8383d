import { formatBytes } from '../../../notation/index.ts';
import { comparePrinted, type Example, exampleSources } from '../../../workbench/index.ts';
import { useWords } from '../../parts/words.ts';
import { chooseExample } from './chosen-example.ts';
import { PrintedBytes, reasonText } from './printed-bytes.tsx';
import './shelf.css';

/** Every example by its source, one click each. */
export function ExampleList() {
  const words = useWords('examples');
  return (
    <>
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
    </>
  );
}

function Item({ example }: { example: Example }) {
  const words = useWords('examples');
  const { id, fault } = example;
  const comparison = comparePrinted(example);
  return (
    <li>
      <button type="button" aria-describedby={`example-${id}`} onClick={() => chooseExample(example)}>
        {words.names[id]}
      </button>
      <div id={`example-${id}`}>
        <p class="mono">{formatBytes(comparison.right)}</p>
        <p class="said">{words.about[id]}</p>
        {fault && (
          <p class="said">
            {words.printed} <PrintedBytes {...comparison} />
            {reasonText(example, comparison, words)}
          </p>
        )}
      </div>
    </li>
  );
}
