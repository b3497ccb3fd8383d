import type { ComponentChildren } from 'preact';
import { useMemo, useRef, useState } from 'preact/hooks';
import {
  type FoundRegister,
  type Profile,
  rareRegisterColumns,
  registerColumns,
  type WrittenColumn,
} from '../../../devices/index.ts';
import { cellText, foundName, foundNumber, type RegisterSort, type RegisterSortKey } from '../../../workbench/index.ts';
import { Drafts } from '../../kit/cell-input.tsx';
import { Grid, type GridColumn } from '../../kit/grid.tsx';
import { sortHead } from '../../kit/table.tsx';
import { useSize } from '../../kit/use-size.ts';
import { allDevices } from '../device/chosen.ts';
import { useWords } from '../words.ts';
import { RegisterDetails } from './register-details.tsx';
import { cellEdit } from './register-edits.ts';
import { Changes, type RegisterActs, Requests } from './register-uses.tsx';

/** Heights of a row, in pixels; the style sheet has the same. */
const ROW = 52;
const CARD = 128;
/** In a narrower grid, in pixels, rows are cards. */
const NARROW = 660;

/** The columns in the order in which they stand, with their least width in pixels, and when they come: the lower, the sooner. */
const widths = {
  name: { least: 124, part: 3, rank: 0 },
  use: { least: 122, part: 0, rank: 0 },
  value: { least: 112, part: 1, rank: 0 },
  address: { least: 92, part: 0, rank: 0 },
  type: { least: 118, part: 0, rank: 0 },
  factor: { least: 60, part: 0, rank: 2 },
  offset: { least: 66, part: 0, rank: 6 },
  unit: { least: 58, part: 0, rank: 1 },
  access: { least: 62, part: 0, rank: 3 },
  names: { least: 140, part: 2, rank: 5 },
  description: { least: 160, part: 3, rank: 4 },
  change: { least: 70, part: 0, rank: 0 },
} as const;
type ColumnId = keyof typeof widths;

/** The columns that a width has room for. */
function columnsIn(width: number, hasValues: boolean): readonly ColumnId[] {
  const ids = (Object.keys(widths) as ColumnId[]).filter((id) => id !== 'value' || hasValues);
  let left = width;
  const chosen = new Set<ColumnId>();
  for (const id of ids.toSorted((one, other) => widths[one].rank - widths[other].rank)) {
    left -= widths[id].least;
    if (left < 0 && widths[id].rank > 0) break;
    chosen.add(id);
  }
  return ids.filter((id) => chosen.has(id));
}

const cardColumns: readonly ColumnId[] = ['name', 'address', 'type', 'value', 'use', 'change'];
/** Columns that sort, by what they are sorted by. */
const sorting: Readonly<Partial<Record<ColumnId, RegisterSortKey>>> = {
  name: 'name',
  address: 'number',
  type: 'type',
  unit: 'unit',
  access: 'access',
};

/** A column with what was read. */
export interface ValueColumn {
  readonly name: string;
  readonly cell: (found: FoundRegister) => ComponentChildren;
}

interface TableProps extends RegisterActs {
  readonly profile: Profile;
  readonly found: readonly FoundRegister[];
  readonly sort: RegisterSort | undefined;
  readonly onSort: (sort: RegisterSort | undefined) => void;
  readonly value?: ValueColumn | undefined;
  /** The cell that is to be edited, such as that of a new register. */
  readonly begin?: { readonly key: string; readonly column: string } | undefined;
}

/** The registers of a device: each with buttons that make its requests, each cell edited where it stands. */
export function RegisterTable(props: TableProps) {
  const { profile, found, sort, onSort, onKeep, onTaken, onRead, onRemove, value, begin } = props;
  const words = useWords('devices');
  const { root, width } = useWidth();
  const device = useLineage(profile);
  const drafts = useMemo(() => new Drafts(), [device]);
  const [open, setOpen] = useState<{ readonly device: number; readonly at: number }>();
  const places = useMemo(() => new Map(profile.registers.map((register, at) => [register, at])), [profile.registers]);
  const atOf = ({ register }: FoundRegister) => places.get(register) ?? -1;
  const cards = width < NARROW;
  const shown = cards
    ? cardColumns.filter((id) => id !== 'value' || value !== undefined)
    : columnsIn(width, value !== undefined);
  const shownFields = new Set<string>(shown);
  const hidden = [...registerColumns, ...rareRegisterColumns].filter((column) => !shownFields.has(column));

  const editOf = (column: WrittenColumn) => (each: FoundRegister) =>
    cellEdit(words, { profile, register: each.register, at: atOf(each), onKeep }, column);
  const text =
    (column: WrittenColumn) =>
    ({ register }: FoundRegister) =>
      cellText(register, column);
  const number = (column: WrittenColumn) => (each: FoundRegister) => <span class="mono">{text(column)(each)}</span>;
  const typeOf = ({ register }: FoundRegister) => (
    <>
      <span class="mono">
        {register.type}
        {register.order === 'ABCD' ? '' : ` ${register.order}`}
      </span>
      <small>{words.tableOf(register)}</small>
    </>
  );
  const numberOf = (each: FoundRegister) => {
    const [printed, address] = words.numberLines(...foundNumber(profile, each));
    return (
      <span class="mono">
        {printed}
        <small class="part">{address}</small>
      </span>
    );
  };
  const cells: Readonly<Record<ColumnId, Pick<GridColumn<FoundRegister>, 'cell' | 'buttons'>>> = {
    name: { cell: foundName },
    use: {
      buttons: true,
      cell: (each, tabIndex) => (
        <Requests profile={profile} found={each} tabIndex={tabIndex} onTaken={onTaken} onRead={onRead} />
      ),
    },
    value: { cell: (each) => value?.cell(each) },
    address: { cell: numberOf },
    type: { cell: typeOf },
    factor: {
      cell: (each) => (
        <>
          {number('factor')(each)}
          <small title={words.scaleText(each.register)}>
            {words.scaleRest(each.register, shownFields.has('offset'))}
          </small>
        </>
      ),
    },
    offset: { cell: number('offset') },
    unit: { cell: text('unit') },
    access: { cell: ({ register }) => words.accesses[register.access] },
    names: { cell: ({ register }) => register.names.map(({ number: of, name }) => `${of} ${name}`).join(', ') },
    description: { cell: text('description') },
    change: {
      buttons: true,
      cell: (each, tabIndex) => (
        <Changes
          register={each.register}
          tabIndex={tabIndex}
          isOpen={isOpen(each)}
          onOpen={() => setOpen(isOpen(each) ? undefined : { device, at: atOf(each) })}
        />
      ),
    },
  };
  const isOpen = (each: FoundRegister) => open?.device === device && open.at === atOf(each);
  const names: Readonly<Record<ColumnId, string>> = {
    ...words.columns,
    address: words.numberColumn,
    use: words.actions,
    change: words.changes,
    value: value?.name ?? '',
  };
  const columns = shown.map((id): GridColumn<FoundRegister> => {
    const { least, part } = widths[id];
    const by = sorting[id];
    return {
      id,
      width: part > 0 ? `minmax(${least}px, ${part}fr)` : `${least}px`,
      ...(by ? sortHead(by, names[id], sort, onSort) : { name: names[id] }),
      ...cells[id],
      ...(isField(id) && { edit: editOf(id) }),
    };
  });
  // Where a column that sorts has no room, a choice sorts in its place.
  const isFew = (Object.keys(sorting) as ColumnId[]).some((id) => cards || !shownFields.has(id));
  return (
    <div ref={root} data-few={isFew ? '' : undefined}>
      {found.length > 0 && (
        <Grid
          class="device-table"
          label={words.table}
          columns={columns}
          rows={found}
          keyOf={(each) => String(atOf(each))}
          cards={cards}
          line={cards ? CARD : ROW}
          drafts={drafts}
          begin={begin}
          below={{
            keys: open?.device === device ? [String(open.at)] : [],
            of: (each) => (
              <RegisterDetails
                name={each.register.name}
                fields={hidden.map((column) => ({ column, edit: editOf(column)(each) }))}
                drafts={drafts}
                onRemove={() => {
                  setOpen(undefined);
                  onRemove(atOf(each));
                }}
              />
            ),
          }}
        />
      )}
    </div>
  );
}

const isField = (id: ColumnId): id is Exclude<ColumnId, 'use' | 'value' | 'change'> =>
  id !== 'use' && id !== 'value' && id !== 'change';

/** How wide an element is, in pixels. */
function useWidth() {
  const root = useRef<HTMLDivElement>(null);
  const [width, setWidth] = useState(NARROW);
  useSize(root, ({ clientWidth }) => {
    // What is folded away has no width.
    if (clientWidth > 0) setWidth(clientWidth);
  });
  return { root, width };
}

/** A number that changes when another device is shown, but not when the device is edited in a copy of itself. */
function useLineage({ id }: Profile): number {
  const known = useRef({ id, number: 0 });
  const { current } = known;
  if (id !== current.id) {
    const { value: latest } = allDevices.history.latest;
    const isCopy = latest?.kind === 'copied' && latest.before.id === current.id && latest.copy.id === id;
    known.current = { id, number: current.number + (isCopy ? 0 : 1) };
  }
  return known.current.number;
}
