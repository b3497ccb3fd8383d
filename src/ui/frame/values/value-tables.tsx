import { useMemo } from 'preact/hooks';
import { numberTypes, type Order, orderName, ordersOf } from '../../../modbus/index.ts';
import { formatValueHex, type ValueView } from '../../../notation/index.ts';
import type { FrameRegister } from '../../../workbench/index.ts';
import { useSame } from '../../parts/steady.ts';
import { useWords } from '../../parts/words.ts';

interface TablesProps {
  readonly views: readonly ValueView[];
  /** From the chosen one on. */
  readonly registers: readonly FrameRegister[];
}

const WIDTHS = [1, 2, 4] as const;

/** Every reading, a table for each width: a line for each order, a column for each type. */
export function ValueTables({ views, registers }: TablesProps) {
  const words = useWords('values');
  const texts = views.filter(({ type }) => type === 'text');
  return (
    <div class="values-registers">
      <div class="value-tables">
        {WIDTHS.filter((width) => width <= registers.length).map((width) => (
          <WidthTable
            key={width}
            width={width}
            views={views.filter(({ type }) => type !== 'text' && numberTypes[type].registers === width)}
            registers={registers}
          />
        ))}
        <table>
          <caption>{words.text}</caption>
          <thead>
            <tr>
              <th scope="col">{words.order}</th>
              <th scope="col">
                text <small>{words.typeNames.text}</small>
              </th>
            </tr>
          </thead>
          <tbody>
            {texts.map((view) => (
              <Line
                key={view.order}
                order={view.order}
                width={1}
                views={[view]}
                from={registers[0]?.from}
                to={registers[view.registers - 1]?.to}
                hex={undefined}
              />
            ))}
          </tbody>
        </table>
      </div>
    </div>
  );
}

/** The readings of one, two or four registers; drawn again only if one of them changes. */
function WidthTable({ width, views, registers }: TablesProps & { readonly width: 1 | 2 | 4 }) {
  const same = useSame({ views, from: registers[0]?.from, to: registers[width - 1]?.to });
  return useMemo(() => <Readings width={width} {...same} />, [width, same]);
}

interface ReadingsProps extends Pick<TablesProps, 'views'> {
  readonly width: 1 | 2 | 4;
  /** The bytes of the registers. */
  readonly from: number | undefined;
  readonly to: number | undefined;
}

function Readings({ width, views, from, to }: ReadingsProps) {
  const words = useWords('values');
  const types = [...new Set(views.map(({ type }) => type))];
  const bits = ({ 1: 'u16', 2: 'u32', 4: 'u64' } as const)[width];
  return (
    <table data-width={width}>
      <caption>{words.width(width)}</caption>
      <thead>
        <tr>
          <th scope="col">{words.order}</th>
          <th scope="col">{words.hex}</th>
          {types.map((type) => (
            <th scope="col" key={type}>
              {type} <small>{words.typeNames[type]}</small>
            </th>
          ))}
        </tr>
      </thead>
      <tbody>
        {ordersOf(width).map((order) => {
          const line = views.filter((view) => view.order === order);
          const reading = line.find(({ type }) => type === bits)?.reading;
          const value = reading?.kind === 'value' && typeof reading.value !== 'string' ? reading.value : 0;
          return (
            <Line
              key={order}
              order={order}
              width={width}
              views={line}
              from={from}
              to={to}
              hex={formatValueHex(value, bits)}
            />
          );
        })}
      </tbody>
    </table>
  );
}

interface LineProps extends ReadingsProps {
  readonly order: Order;
  readonly hex: string | undefined;
}

function Line({ order, width, views, from, to, hex }: LineProps) {
  const words = useWords('values');
  return (
    <tr data-kind="registers" data-from={from} data-to={to}>
      <th scope="row">
        <span class="mono">{orderName(order, width)}</span> <small>{words.orderHints[order]}</small>
      </th>
      {hex !== undefined && (
        <td class="mono" data-name={words.hex}>
          {hex}
        </td>
      )}
      {views.map((view) => (
        <td key={view.type} class={view.likely ? 'mono likely' : 'mono'} data-name={view.type}>
          <Cell view={view} />
        </td>
      ))}
    </tr>
  );
}

function Cell({ view: { type, text, reading } }: { readonly view: ValueView }) {
  const words = useWords('values');
  if (reading.kind === 'not-a-digit') return <span title={words.noDigits}>{words.none}</span>;
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
