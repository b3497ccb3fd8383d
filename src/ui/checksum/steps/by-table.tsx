import { type CrcSteps, twoTableStep, twoTables } from '../../../modbus/index.ts';
import type { StepPlace } from '../../../workbench/index.ts';
import { byteHex, registerHex } from '../../../workbench/index.ts';
import { Table } from '../../kit/table.tsx';
import { useWords } from '../../parts/words.ts';

interface ByTableProps {
  readonly steps: CrcSteps;
  readonly place: StepPlace;
}

/** The current byte with the table, why that is the same as its shifts, and with two tables. */
export function ByTable({ steps, place: { at, shift } }: ByTableProps) {
  const words = useWords('checksumSteps').table;
  const { form } = steps;
  const { reflected } = form;
  const hex = (value: number) => registerHex(form.bits, value);
  const { index, entry, mixed, moved, after } = steps.byte(at);
  return (
    <div class="by-table">
      <h3>{words.title}</h3>
      <table class="numbers">
        <caption>{words.one(at)}</caption>
        <tbody>
          <Row name={words.index} value={byteHex(index)} how={words.indexIs(hex(mixed), reflected)} />
          <Row name={words.entry} value={hex(entry)} />
          <Row name={words.moved} value={hex(moved)} />
          <Row name={words.after} value={hex(after)} how={words.xorOf(hex(moved), hex(entry))} />
        </tbody>
      </table>
      <h4>{words.why}</h4>
      <p>{words.whyText(reflected)}</p>
      <Table
        class="numbers split"
        columns={[
          { name: words.shifts, cell: (_, shifts) => shifts },
          { name: words.whole, class: 'mono', cell: ({ whole }) => hex(whole) },
          { name: words.alone(reflected), class: 'mono', cell: (parts) => hex(parts.index) },
          { name: words.rest, class: 'mono', cell: ({ rest }) => hex(rest) },
        ]}
        rows={steps.split(at)}
        keyOf={(_, shifts) => shifts}
        attributes={(_, shifts) => ({ 'aria-current': shifts === shift ? 'step' : undefined })}
      />
      <p>{words.becomes(byteHex(index), hex(entry))}</p>
      <ByTwoTables steps={steps} at={at} />
    </div>
  );
}

function ByTwoTables({ steps, at }: { steps: CrcSteps; at: number }) {
  const { two: words, table } = useWords('checksumSteps');
  const tables = twoTables(steps);
  if (!tables) return null;
  const { before, index, after } = twoTableStep(tables, steps, at);
  return (
    <>
      <h4>{words.title}</h4>
      <p>
        {words.intro} {steps.form.reflected && words.names}
      </p>
      <table class="numbers">
        <caption>{table.one(at)}</caption>
        <tbody>
          <Row
            name={words.index}
            value={byteHex(index)}
            how={words.indexIs(byteHex(steps.bytes[at] as number), byteHex(before.first))}
          />
          <Row
            name={words.first}
            value={byteHex(after.first)}
            how={words.firstIs(byteHex(before.second), byteHex(tables.first[index] as number))}
          />
          <Row name={words.second} value={byteHex(after.second)} how={words.secondIs} />
        </tbody>
      </table>
    </>
  );
}

interface RowProps {
  readonly name: string;
  readonly value: string;
  readonly how?: string;
}

const Row = ({ name, value, how }: RowProps) => (
  <tr>
    <th scope="row">{name}</th>
    <td class="mono">{value}</td>
    <td class="how">{how}</td>
  </tr>
);
