import { formatBytes } from '../../../notation/index.ts';
import { type ChecksumCardWords, loadChecksumCardWords, loadExampleWords } from '../../../words/index.ts';
import {
  type CardRow,
  cardC,
  cardCsv,
  cardRows,
  exampleRows,
  exampleSources,
  printedAs,
} from '../../../workbench/index.ts';
import './checksum-card.css';

export interface CardProps {
  /** Takes bytes as the input, and an algorithm as the chosen one. */
  readonly onUse: (bytes: string, algorithm: string) => void;
  /** Copies a text, and says what was copied. */
  readonly onCopy: (text: string, what: string) => void;
}

/** The test card with its words. Its rows are calculated once. */
export async function load() {
  const [words, examples] = await Promise.all([loadChecksumCardWords(), loadExampleWords()]);
  const rows = [...cardRows(words.sources), ...exampleRows(exampleSources, examples.sources)];
  return (props: CardProps) => <Card {...props} words={words} rows={rows} />;
}

interface ViewProps extends CardProps {
  readonly words: ChecksumCardWords;
  readonly rows: readonly CardRow[];
}

/** Values in print beside the calculated ones. */
function Card(props: ViewProps) {
  const { words, rows, onCopy } = props;
  return (
    <div class="card">
      <p class="said">{words.intro}</p>
      <div class="actions">
        <button type="button" onClick={() => onCopy(cardCsv(rows, Object.values(words.columns)), words.csv)}>
          {words.copyCsv}
        </button>
        <button type="button" onClick={() => onCopy(cardC(rows), words.c)}>
          {words.copyC}
        </button>
      </div>
      <Table {...props} />
    </div>
  );
}

function Table({ rows, words, onUse }: ViewProps) {
  const { columns } = words;
  return (
    <table>
      <caption>{words.known}</caption>
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
