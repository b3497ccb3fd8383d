import { entityNumber, formatHex } from '../../../../notation/index.ts';
import type { BitRow } from '../../../../workbench/index.ts';
import { Table } from '../../../kit/table.tsx';
import { useWords } from '../../words.ts';

/** The coils or inputs of a frame, a row for each byte, the lowest address first. */
export function BitList({ rows }: { readonly rows: readonly BitRow[] }) {
  const words = useWords('values');
  const { address, states, byte } = words.bitColumns;
  return (
    <Table<BitRow>
      class="bit-list"
      caption={words.bitStates}
      columns={[
        { name: address, class: 'mono', cell: (row) => placeText(row) },
        { name: states, class: 'mono', cell: ({ bits }) => bits.join(' ') },
        { name: byte, class: 'mono', cell: (row) => formatHex(row.byte, 2).slice(2) },
      ]}
      rows={rows}
      keyOf={({ from }) => from}
      attributes={({ from, to }) => ({ 'data-kind': 'bits', 'data-from': String(from), 'data-to': String(to) })}
    />
  );
}

/** The addresses of a row, with the numbers that manuals print. */
function placeText({ first, bits, table }: BitRow): string {
  const last = first + bits.length - 1;
  const range = (one: string, other: string) => (one === other ? one : `${one}–${other}`);
  const addresses = range(String(first), String(last));
  return table ? `${addresses} (${range(entityNumber(table, first), entityNumber(table, last))})` : addresses;
}
