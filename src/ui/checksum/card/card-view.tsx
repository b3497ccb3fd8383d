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
import { Table } from '../../kit/table.tsx';
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
  const names = words.columns;
  const columns = [
    {
      name: names.bytes,
      class: 'mono',
      cell: ({ bytes, algorithm }: CardRow) => (
        <>
          {formatBytes(bytes)}{' '}
          <button type="button" aria-label={words.useNamed(formatBytes(bytes))} onClick={() => onUse(bytes, algorithm)}>
            {words.use}
          </button>
        </>
      ),
    },
    { name: names.algorithm, cell: ({ algorithm }: CardRow) => algorithm },
    { name: names.printed, class: 'mono', cell: ({ printed }: CardRow) => printed },
    { name: names.value, class: 'mono', cell: printedAs },
    { name: names.verdict, cell: ({ verdict }: CardRow) => <b class="verdict-word">{words.verdicts[verdict]}</b> },
    { name: names.source, cell: ({ source }: CardRow) => source },
  ];
  return (
    <div class="card">
      <p class="said">{words.intro}</p>
      <div class="actions">
        <button type="button" onClick={() => void copy(cardCsv(rows, Object.values(names)), words.csv)}>
          {words.copyCsv}
        </button>
        <button type="button" onClick={() => void copy(cardC(rows), words.c)}>
          {words.copyC}
        </button>
      </div>
      <Table
        caption={words.known}
        columns={columns}
        rows={rows}
        keyOf={({ bytes, algorithm, printed, source }) => `${bytes} ${algorithm} ${printed} ${source}`}
        attributes={({ verdict }) => ({ 'data-verdict': verdict })}
        narrow="cards many"
      />
    </div>
  );
}
