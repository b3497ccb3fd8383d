import { Component } from 'preact';
import type { Reading } from '../../modbus/index.ts';
import { words } from '../language.ts';
import { explain, type Row } from './rows.ts';

/** A line for each field and each item of a list: where, which bytes, which bits, and what they mean here. */
export function Explanation({ reading, bytes }: { reading: Reading; bytes: Uint8Array }) {
  const { columns } = words.page;
  return (
    <section class="panel" aria-labelledby="every-byte">
      <h2 id="every-byte">{words.page.everyByte}</h2>
      <table class="explanation">
        <thead>
          <tr>
            <th scope="col">{columns.byte}</th>
            <th scope="col">{columns.hex}</th>
            <th scope="col">{columns.decimal}</th>
            <th scope="col">{reading.transport === 'ascii' ? words.page.characterColumn : columns.bits}</th>
            <th scope="col">{columns.means}</th>
            <th scope="col">{columns.section}</th>
          </tr>
        </thead>
        <tbody>
          {explain(reading, bytes).map((row) => (
            <Line key={row.key} row={row} />
          ))}
        </tbody>
      </table>
    </section>
  );
}

/** A line is drawn again only when its text changes. */
class Line extends Component<{ row: Row }> {
  override shouldComponentUpdate({ row }: { row: Row }) {
    const shown = this.props.row;
    return (Object.keys(row) as (keyof Row)[]).some((part) => row[part] !== shown[part]);
  }

  render() {
    const { row } = this.props;
    return (
      <tr
        data-kind={row.kind}
        data-severity={row.severity}
        data-from={row.from}
        data-to={row.to}
        class={row.item ? 'item' : undefined}
      >
        <td class="mono offset">{row.offset}</td>
        <td class="mono hex">{row.hex}</td>
        <td class="mono decimal">{row.decimal}</td>
        <td class="mono bits">{row.characters || row.bits}</td>
        <td class="means">
          {row.label && <b>{row.label}. </b>}
          {row.meaning}
          {row.problems && <span class="problem">{row.problems}</span>}
        </td>
        <td class="section">{row.section}</td>
      </tr>
    );
  }
}
