import { useMemo } from 'preact/hooks';
import { formatBytes } from '../../../notation/index.ts';
import {
  type CardRow,
  cardC,
  cardCsv,
  cardRows,
  exampleRows,
  exampleSources,
  printedAs,
} from '../../../workbench/index.ts';
import { useWords } from '../../parts/words.ts';
import { copy } from '../copied-value.tsx';
import './checksum-card.css';

interface CardProps {
  /** Takes bytes as the input, and an algorithm as the chosen one. */
  readonly onUse: (bytes: Uint8Array, algorithm: string) => void;
}

/** Values in print beside the calculated ones. */
export function Card({ onUse }: CardProps) {
  const words = useWords('checksumCard');
  const { sources } = useWords('examples');
  const rows = useMemo(() => [...cardRows(words.sources), ...exampleRows(exampleSources, sources)], [words, sources]);
  return (
    <div class="card">
      <p class="said">{words.intro}</p>
      <div class="actions">
        <button type="button" onClick={() => void copy(cardCsv(rows, Object.values(words.columns)), words.csv)}>
          {words.copyCsv}
        </button>
        <button type="button" onClick={() => void copy(cardC(rows), words.c)}>
          {words.copyC}
        </button>
      </div>
      <Table rows={rows} onUse={onUse} />
    </div>
  );
}

function Table({ rows, onUse }: CardProps & { readonly rows: readonly CardRow[] }) {
  const words = useWords('checksumCard');
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
                <button
                  type="button"
                  aria-label={words.useNamed(bytes)}
                  onClick={() => onUse(row.bytes, row.algorithm)}
                >
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
