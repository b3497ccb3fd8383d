import { formatBytes } from '../../notation/index.ts';
import {
  type ChecksumCardWords,
  loadChecksumCardWords,
  loadReferenceWords,
  loadShelfWords,
} from '../../words/index.ts';
import { exampleSources } from '../examples/examples.ts';
import { type CardRow, cardC, cardCsv, cardRows, exampleRows, misprintRows, printedAs } from './card.ts';
import './checksum-card.css';

export interface CardProps {
  /** Takes bytes as the input, and an algorithm as the chosen one. */
  readonly onUse: (bytes: string, algorithm: string) => void;
  /** Copies a text, and says what was copied. */
  readonly onCopy: (text: string, what: string) => void;
}

/** The test card with its words. Its rows are worked out once. */
export async function load() {
  const [words, shelf, reference] = await Promise.all([
    loadChecksumCardWords(),
    loadShelfWords(),
    loadReferenceWords(),
  ]);
  const known = [...cardRows(words.sources), ...exampleRows(exampleSources, shelf.examples.sources)];
  const wrong = misprintRows(reference.misprints);
  return (props: CardProps) => <Card {...props} words={words} known={known} wrong={wrong} />;
}

interface ViewProps extends CardProps {
  readonly words: ChecksumCardWords;
  readonly known: readonly CardRow[];
  readonly wrong: readonly CardRow[];
}

/** Values in print beside those worked out here. */
function Card(props: ViewProps) {
  const { words, known, wrong, onCopy } = props;
  const all = [...known, ...wrong];
  return (
    <div class="card">
      <p class="said">{words.intro}</p>
      <div class="actions">
        <button type="button" onClick={() => onCopy(cardCsv(all, Object.values(words.columns)), words.csv)}>
          {words.copyCsv}
        </button>
        <button type="button" onClick={() => onCopy(cardC(all), words.c)}>
          {words.copyC}
        </button>
      </div>
      <Table {...props} title={words.known} rows={known} />
      <p class="said">{words.circulatingIntro}</p>
      <Table {...props} title={words.circulating} rows={wrong} />
    </div>
  );
}

function Table({
  title,
  rows,
  words,
  onUse,
}: ViewProps & { readonly title: string; readonly rows: readonly CardRow[] }) {
  const { columns } = words;
  return (
    <table>
      <caption>{title}</caption>
      <thead>
        <tr>
          {Object.entries(columns).map(([key, column]) => (
            <th key={key} scope="col">
              {column}
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {rows.map((row) => {
          const bytes = formatBytes(row.bytes);
          return (
            <tr key={`${bytes} ${row.algorithm} ${row.printed} ${row.source}`} data-verdict={row.verdict}>
              <th scope="row" class="mono">
                {bytes}{' '}
                <button type="button" aria-label={words.useNamed(bytes)} onClick={() => onUse(bytes, row.algorithm)}>
                  {words.use}
                </button>
              </th>
              <td data-column={columns.algorithm}>{row.algorithm}</td>
              <td data-column={columns.printed} class="mono">
                {row.printed}
              </td>
              <td data-column={columns.value} class="mono">
                {printedAs(row)}
              </td>
              <td data-column={columns.verdict}>
                <b class="verdict-word">{words.verdicts[row.verdict]}</b>
              </td>
              <td data-column={columns.source}>{row.source}</td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}
