import { Component } from 'preact';
import { DrawnWhenSeen } from '../drawn-when-seen.ts';
import { words } from '../language.ts';
import './explanation.css';
import { type LazyRow, linesOf, type Row } from './rows.ts';

/** A line for each field and each item of a list: where, which bytes, which bits, and what they mean here. */
export function Explanation(said: Parameters<typeof linesOf>[0]) {
  const { reading } = said;
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
        {groupsOf(linesOf(said)).map((lines, index) => (
          <Group key={index} lines={lines} />
        ))}
      </table>
    </section>
  );
}

/** Lines that are drawn together: so many that few groups are watched, so few that little is drawn out of sight. */
const GROUP = 12;
type Lines = readonly LazyRow[];

function groupsOf(lines: Lines): Lines[] {
  return Array.from({ length: Math.ceil(lines.length / GROUP) }, (_, index) =>
    lines.slice(index * GROUP, (index + 1) * GROUP),
  );
}

/** Lines that are neither laid out nor drawn while they are out of sight. */
class Group extends DrawnWhenSeen<{ lines: Lines }, HTMLTableSectionElement> {
  render() {
    const rows = this.props.lines.map((line) => line());
    return (
      <tbody ref={this.element} style={{ '--rows': rows.length }}>
        {rows.map((row) => (
          <Line key={row.key} row={row} />
        ))}
      </tbody>
    );
  }
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
