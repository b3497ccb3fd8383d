import { useMemo } from 'preact/hooks';
import {
  fromRegisters,
  isTextType,
  type Order,
  orderName,
  ordersOf,
  registersOf,
  toHex,
} from '../../../../modbus/index.ts';
import type { ValueView } from '../../../../notation/index.ts';
import type { FrameRegister } from '../../../../workbench/index.ts';
import { useSame } from '../../steady.ts';
import { useWords } from '../../words.ts';

interface TablesProps {
  readonly views: readonly ValueView[];
  /** From the chosen one on. */
  readonly registers: readonly FrameRegister[];
}

const WIDTHS = [1, 2, 3, 4] as const;
type Width = (typeof WIDTHS)[number];

/** Every reading, a table for each width: a line for each order, a column for each type. */
export function ValueTables({ views, registers }: TablesProps) {
  const words = useWords('values');
  const texts = views.filter(({ type }) => isTextType(type));
  const numbers = (width: Width) => views.filter(({ type }) => !isTextType(type) && registersOf(type) === width);
  return (
    <div class="values-registers">
      <div class="value-tables in-row">
        {WIDTHS.filter((width) => numbers(width).length > 0).map((width) => (
          <WidthTable
            key={width}
            width={width}
            caption={words.width(width)}
            views={numbers(width)}
            registers={registers}
          />
        ))}
        {texts.length > 0 && <WidthTable caption={words.text} views={texts} registers={registers} />}
      </div>
    </div>
  );
}

interface WidthProps extends TablesProps {
  /** Registers of a value; none for texts, which have any length. */
  readonly width?: Width;
  readonly caption: string;
}

/** The readings of one width; drawn again only if one of them changes, or they move. */
function WidthTable({ views, registers, ...of }: WidthProps) {
  const last = views.reduce((most, view) => Math.max(most, view.registers), 1);
  const words = registers.slice(0, of.width ?? 0).map(({ value }) => value);
  const same = useSame({ views, words, from: registers[0]?.from, to: registers[last - 1]?.to });
  return useMemo(() => <Readings {...of} {...same} />, [same]);
}

interface ReadingsProps extends Omit<WidthProps, 'registers'> {
  readonly words: readonly number[];
  /** The bytes of the registers. */
  readonly from: number | undefined;
  readonly to: number | undefined;
}

function Readings({ width, caption, views, words: registers, from, to }: ReadingsProps) {
  const words = useWords('values');
  const types = [...new Set(views.map(({ type }) => type))];
  // Orders that only four registers have are rare: shown where what is expected stands in one.
  const isShown = (order: Order) =>
    ordersOf(2).includes(order) || views.some((view) => view.order === order && view.likely);
  return (
    <table data-width={width}>
      <caption>{caption}</caption>
      <thead>
        <tr>
          <th scope="col">{words.order}</th>
          {width !== undefined && <th scope="col">{words.hex}</th>}
          {types.map((type) => (
            <th scope="col" key={type}>
              {type} <small>{words.typeNames[type]}</small>
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {ordersOf(width ?? 1)
          .filter(isShown)
          .map((order) => (
            <tr key={order} data-kind="registers" data-from={from} data-to={to}>
              <th scope="row">
                <span class="mono">{orderName(order, width ?? 1)}</span> <small>{words.orderHints[order]}</small>
              </th>
              {width !== undefined && (
                <td class="mono" data-name={words.hex}>
                  {`0x${toHex(fromRegisters(registers, order))}`}
                </td>
              )}
              {types
                .map((type) => views.find((view) => view.type === type && view.order === order) ?? { ...NOTHING, type })
                .map((view) => (
                  <td key={view.type} class={view.likely ? 'mono likely' : 'mono'} data-name={view.type}>
                    <Cell view={view} />
                  </td>
                ))}
            </tr>
          ))}
      </tbody>
    </table>
  );
}

/** A type that has no value of its own in this order. */
const NOTHING = { text: '', likely: undefined, reading: undefined };

function Cell({
  view: { type, text, reading },
}: {
  readonly view: Pick<ValueView, 'type' | 'text'> & { readonly reading: ValueView['reading'] | undefined };
}) {
  const words = useWords('values');
  if (reading?.kind === 'no-value') return <span title={words.noDigits}>{words.none}</span>;
  if (text === '') return <>{words.none}</>;
  if (type !== 'bits') return <>{text.replaceAll('\n', ' ')}</>;
  // A byte a line: sixteen digits in one make the table too wide for two beside each other.
  const [first, second, ...rest] = text.split('_');
  return (
    <>
      {first} {second}
      <br />
      {rest.join(' ')}
    </>
  );
}
