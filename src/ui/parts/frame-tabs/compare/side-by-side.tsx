import type { Run } from '../../../../diagnosis/index.ts';
import { formatBytes, writeBytes } from '../../../../notation/index.ts';
import {
  type Compared,
  type ComparedBlock,
  character,
  characters,
  comparedBlocks,
} from '../../../../workbench/index.ts';
import { useWords } from '../../words.ts';
import { useLabel } from './difference-list.tsx';

/** The bytes of both frames, field by field, built above sent. Frames that are not laid out alike stand whole. */
export function SideBySide({ comparison, mine, theirs, ascii }: Compared) {
  const words = useWords('compare');
  const sentAscii = comparison.transport === 'ascii';
  if (!comparison.alike) {
    return (
      <dl class="whole">
        <dt>{words.built}</dt>
        <dd class="mono">{ascii ? characters(mine) : formatBytes(mine)}</dd>
        <dt>{words.was}</dt>
        <dd class="mono">{sentAscii ? characters(theirs) : formatBytes(theirs)}</dd>
      </dl>
    );
  }
  const write = (byte: number) => (ascii ? character(byte) : writeBytes(Uint8Array.of(byte), 'plain'));
  return (
    <>
      <h3 id="lines">{words.lines}</h3>
      <ol class="lines" aria-labelledby="lines">
        {comparedBlocks(comparison.runs, COLUMNS).map((block, index) => (
          <BlockCells key={index} block={block} mine={mine} theirs={theirs} write={write} />
        ))}
      </ol>
    </>
  );
}

/** Columns that stand side by side on the narrowest screen. */
const COLUMNS = 8;

interface BlockProps {
  readonly block: ComparedBlock;
  readonly mine: Uint8Array;
  readonly theirs: Uint8Array;
  readonly write: (byte: number) => string;
}

function BlockCells({ block, mine, theirs, write }: BlockProps) {
  const words = useWords('compare');
  const { short } = useWords('page');
  const label = useLabel()(block.name);
  const { name, kind, columns } = block;
  const mark = columns.find((column) => column.kind !== 'equal')?.kind ?? 'equal';
  return (
    <li class="field" data-kind={kind} data-severity={mark === 'equal' ? undefined : 'error'}>
      <span class="name" title={label}>
        {short[name] ?? label.toLowerCase()}
        {mark !== 'equal' && <b class="mark">{words.marks[mark]}</b>}
      </span>
      <span class="row">
        <span class="side unseen">{words.built} </span>
        {columns.map((column, index) => (
          <Cell key={index} bytes={mine} at={column.mine} kind={column.kind} write={write} lit={column.mine} />
        ))}
      </span>
      <span class="row">
        <span class="side unseen"> {words.was} </span>
        {columns.map((column, index) => (
          <Cell key={index} bytes={theirs} at={column.theirs} kind={column.kind} write={write} lit={undefined} />
        ))}
      </span>
    </li>
  );
}

interface CellProps {
  readonly bytes: Uint8Array;
  readonly at: number | undefined;
  readonly kind: Run['kind'];
  readonly write: (byte: number) => string;
  /** The byte of the current frame that is lit with this cell. */
  readonly lit: number | undefined;
}

function Cell({ bytes, at, kind, write, lit }: CellProps) {
  const { gap } = useWords('compare');
  const byte = at === undefined ? undefined : bytes[at];
  return (
    <span class="pair" data-run={kind} data-from={lit} data-to={lit === undefined ? undefined : lit + 1}>
      {byte === undefined ? gap : write(byte)}{' '}
    </span>
  );
}
