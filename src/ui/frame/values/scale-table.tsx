import { add, divide, formatFraction, fraction, multiply, subtract } from '../../../modbus/index.ts';
import { type UnitScale, writeInUnits } from '../../../notation/index.ts';
import { useWords } from '../../parts/words.ts';

/** Steps from the least to the most: quarters, as manuals print them. */
const STEPS = 4;

/** Values from the least to the most with their raw numbers, as tables of manuals have them. */
export function ScaleTable({ known }: { readonly known: UnitScale }) {
  const words = useWords('values');
  const { least, most, decimals } = known.scale;
  if (least === undefined || most === undefined) return null;
  const step = divide(subtract(most, least), fraction(STEPS));
  const values = Array.from({ length: STEPS + 1 }, (_, index) => add(least, multiply(step, fraction(index))));
  return (
    <table class="scale-table">
      <caption>{words.scaleTable}</caption>
      <thead>
        <tr>
          <th scope="col">{known.unit || words.inUnits}</th>
          <th scope="col">{words.raw}</th>
        </tr>
      </thead>
      <tbody>
        {values.map((value, index) => {
          const written = writeInUnits(value, known);
          return (
            <tr key={index}>
              <th scope="row" class="mono">
                {formatFraction(value, decimals)}
              </th>
              <td class="mono">{written.kind === 'registers' ? words.rawFor(written.inUnits) : words.doesNotFit}</td>
            </tr>
          );
        })}
      </tbody>
    </table>
  );
}
