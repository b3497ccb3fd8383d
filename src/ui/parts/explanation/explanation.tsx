import { Component } from 'preact';
import type { Reading } from '../../../modbus/index.ts';
import type { ToolWords } from '../../../words/index.ts';
import { type ExplanationRow, type FrameNames, type LazyExplanationRow, linesOf } from '../../../workbench/index.ts';
import { DrawnWhenSeen } from '../../kit/drawn-when-seen.ts';
import { words as pageWords } from '../page-words.ts';
import './explanation.css';
import { explanationWords } from './explanation-words.ts';

export interface ExplanationProps {
  readonly reading: Reading;
  readonly bytes: Uint8Array;
  readonly words: ToolWords;
  readonly names?: FrameNames | undefined;
}

/** Lines that are drawn until more are asked for; hardly a legal frame has as many. */
const FIRST = 600;

/** A line for each field and each item of a list: where, which bytes, which bits, and what they mean here. */
export class Explanation extends Component<ExplanationProps, { most: number }> {
  override state = { most: FIRST };

  render() {
    const { words, ...of } = this.props;
    const { most } = this.state;
    const { columns, everyByte, characterColumn } = pageWords.page;
    const lines = linesOf({ ...of, words: explanationWords(words) });
    return (
      <section class="panel" aria-labelledby="every-byte">
        <h2 id="every-byte">{everyByte}</h2>
        <table class="explanation">
          <thead>
            <tr>
              <th scope="col">{columns.byte}</th>
              <th scope="col">{columns.hex}</th>
              <th scope="col">{columns.decimal}</th>
              <th scope="col">{of.reading.transport === 'ascii' ? characterColumn : columns.bits}</th>
              <th scope="col">{columns.means}</th>
              <th scope="col">{columns.section}</th>
            </tr>
          </thead>
          {groupsOf(lines.slice(0, most)).map((group, index) => (
            <Group key={index} lines={group} />
          ))}
        </table>
        {lines.length > most && (
          <p class="said">
            {words.moreLines(lines.length - most)}{' '}
            <button type="button" onClick={() => this.setState({ most: most + FIRST })}>
              {words.showMoreLines(Math.min(FIRST, lines.length - most))}
            </button>
          </p>
        )}
      </section>
    );
  }
}

/** Lines that are drawn together: so many that few groups are watched, so few that little is drawn out of sight. */
const GROUP = 12;
type Lines = readonly LazyExplanationRow[];

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
class Line extends Component<{ row: ExplanationRow }> {
  override shouldComponentUpdate({ row }: { row: ExplanationRow }) {
    const shown = this.props.row;
    return (Object.keys(row) as (keyof ExplanationRow)[]).some((part) => row[part] !== shown[part]);
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
