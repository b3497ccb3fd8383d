import { type NamedRow, rawBeside } from '../../../../workbench/index.ts';
import { Table } from '../../../kit/table.tsx';
import { useWords } from '../../words.ts';

/** The values that the chosen device has names for: name, value, unit, and the number as it is sent. */
export function NamedList({ rows }: { readonly rows: readonly NamedRow[] }) {
  const words = useWords('values');
  const { name, value, unit, raw } = words.namedColumns;
  return (
    <Table<NamedRow>
      class="named-list"
      caption={words.named}
      columns={[
        { name, cell: (row) => row.value.name },
        { name: value, class: 'number', cell: (row) => <b>{words.namedValue(row.value)}</b> },
        { name: unit, cell: (row) => row.value.register.unit },
        { name: raw, class: 'number', cell: (row) => String(rawBeside(row.value) ?? '') },
      ]}
      rows={rows}
      keyOf={(_, index) => index}
      attributes={({ from, to }) => ({ 'data-kind': 'registers', 'data-from': String(from), 'data-to': String(to) })}
    />
  );
}
