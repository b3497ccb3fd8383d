import { add, divide, type Fraction, formatFraction, fraction, multiply, subtract } from '../../../../modbus/index.ts';
import { type UnitScale, writeInUnits } from '../../../../notation/index.ts';
import { Table } from '../../../kit/table.tsx';
import { useWords } from '../../words.ts';

/** Steps from the least to the most: quarters, as manuals print them. */
const STEPS = 4;

/** Values from the least to the most with their raw numbers, as tables of manuals have them. */
export function ScaleTable({ known }: { readonly known: UnitScale }) {
  const words = useWords('values');
  const { least, most, decimals } = known.scale;
  if (least === undefined || most === undefined) return null;
  const step = divide(subtract(most, least), fraction(STEPS));
  const values = Array.from({ length: STEPS + 1 }, (_, index) => add(least, multiply(step, fraction(index))));
  const columns = [
    { name: known.unit || words.inUnits, class: 'mono', cell: (value: Fraction) => formatFraction(value, decimals) },
    {
      name: words.raw,
      class: 'mono',
      cell: (value: Fraction) => {
        const written = writeInUnits(value, known);
        return written.kind === 'registers' ? words.rawFor(written.inUnits) : words.doesNotFit;
      },
    },
  ];
  return (
    <Table class="scale-table" caption={words.scaleTable} columns={columns} rows={values} keyOf={(_, index) => index} />
  );
}
