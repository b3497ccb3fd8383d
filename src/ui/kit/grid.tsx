import type { ComponentChildren, TargetedEvent, TargetedKeyboardEvent } from 'preact';
import { useLayoutEffect, useMemo, useRef, useState } from 'preact/hooks';
import { type CellEdit, type CellExit, CellInput, CellSaid, type Drafts } from './cell-input.tsx';
import './grid.css';
import { lineAt, type TallLines, topOf } from './tall-lines.ts';
import { useSize } from './use-size.ts';

export interface GridColumn<Row> {
  /** Names it in style sheets, too. */
  readonly id: string;
  readonly name: string;
  readonly head?: ComponentChildren;
  readonly sorted?: 'ascending' | 'descending' | undefined;
  /** A track of CSS. */
  readonly width: string;
  /** What stands in a cell. Its buttons are `data-stop`, and get this `tabIndex`. */
  readonly cell: (row: Row, tabIndex: number) => ComponentChildren;
  /** Whether its cells hold buttons: these get the focus, and the cells do not. */
  readonly buttons?: boolean;
  readonly edit?: (row: Row) => CellEdit;
}

interface GridProps<Row> {
  readonly label: string;
  readonly class?: string;
  /** The first column is the head of its row. */
  readonly columns: readonly GridColumn<Row>[];
  readonly rows: readonly Row[];
  /** Tells a row from the others, also when it was edited. */
  readonly keyOf: (row: Row) => string;
  /** Rows are cards: the style sheet places the cells by their `data-column`. */
  readonly cards: boolean;
  /** The height of a row, in pixels; the style sheet has the same. */
  readonly line: number;
  readonly drafts: Drafts;
  /** What stands below a row; its rows are named, because they may be out of sight. */
  readonly below?: { readonly keys: readonly string[]; readonly of: (row: Row) => ComponentChildren };
  /** Brings a cell into sight, and begins to edit it; another object each time. */
  readonly begin?: { readonly key: string; readonly column: string } | undefined;
}

/** A place in the grid that has the focus, or is to get it: of several buttons in a cell, `nth`. */
interface Place {
  readonly row: number;
  readonly column: string;
  readonly nth: number;
}

/** A place that is to get the focus as soon as it is drawn; counted from a row that may have moved meanwhile. */
interface Wanted extends Place {
  readonly from?: string | undefined;
  readonly by: number;
}

// Elements of a table that are placed as a grid lose what they are, in some browsers, unless it is said.
const GRID = { role: 'grid' } as const;
const GROUP = { role: 'rowgroup' } as const;
const ROW = { role: 'row' } as const;
const HEAD = { role: 'columnheader' } as const;
const ROW_HEAD = { role: 'rowheader' } as const;
const CELL = { role: 'gridcell' } as const;

/** How many cells to the right and rows down an exit leads. */
const STEPS: Readonly<Record<Exclude<CellExit, 'nowhere'>, readonly [across: number, down: number]>> = {
  back: [0, 0],
  next: [1, 0],
  previous: [-1, 0],
  down: [0, 1],
  up: [0, -1],
};

/** Rows drawn above and below those in sight. */
const BEYOND = 6;

/** A table of any length, of which the rows in sight are drawn, and whose cells are edited where they stand. */
export function Grid<Row>(props: GridProps<Row>) {
  const { label, class: given = '', columns, rows, keyOf, cards, line, drafts, below, begin } = props;
  const scroller = useRef<HTMLDivElement>(null);
  const [scrolled, setScrolled] = useState(0);
  const [view, setView] = useState(0);
  const [active, setActive] = useState<Place>({ row: 0, column: columns[0]?.id ?? '', nth: 0 });
  const [heights, setHeights] = useState<ReadonlyMap<string, number>>(new Map());
  const wanted = useRef<Wanted>(undefined);
  const [, draw] = useState({});
  const indexOf = useMemo(() => new Map(rows.map((row, index) => [keyOf(row), index])), [rows]);

  const keysBelow = new Set([...(below?.keys ?? []), ...drafts.ids.map((id) => id.split('-')[0] ?? '')]);
  const heightsBelow = [...keysBelow].flatMap((key): [number, number][] => {
    const index = indexOf.get(key);
    return index === undefined ? [] : [[index, heights.get(key) ?? 0]];
  });
  const all: TallLines = { count: rows.length, line, below: new Map(heightsBelow) };
  const from = Math.max(0, lineAt(all, scrolled) - BEYOND);
  const to = Math.min(rows.length, lineAt(all, scrolled + view) + 1 + BEYOND);
  const current = Math.min(active.row, rows.length - 1);
  // The row that has the focus, and rows with a text that is wrong, stay though they are scrolled away.
  const kept = [current, ...heightsBelow.map(([index]) => index)].filter((index) => index >= 0);
  const drawn = [...new Set([...Array.from({ length: Math.max(0, to - from) }, (_, at) => from + at), ...kept])];

  useSize(scroller, ({ clientHeight }) => setView(clientHeight));

  /** Brings a row into sight, below the head that stays. */
  const show = (index: number) => {
    const box = scroller.current;
    if (!box) return;
    const head = box.querySelector<HTMLElement>('thead')?.offsetHeight ?? 0;
    const [top, bottom] = [topOf(all, index), topOf(all, index + 1)];
    if (top < box.scrollTop) box.scrollTop = top;
    else if (bottom > box.scrollTop + box.clientHeight - head) box.scrollTop = bottom + head - box.clientHeight;
    setScrolled(box.scrollTop);
  };
  const goTo = (place: Place, from?: string, by = 0) => {
    wanted.current = { ...place, from, by };
    draw({});
  };
  useLayoutEffect(() => {
    const { current: want } = wanted;
    if (want === undefined || rows.length === 0) return;
    const moved = want.from === undefined ? undefined : indexOf.get(want.from);
    const row = Math.max(0, Math.min(rows.length - 1, moved === undefined ? want.row : moved + want.by));
    const stops = stopsIn(scroller.current, row);
    const inColumn = stops.filter((stop) => columnOf(stop) === want.column);
    const stop = inColumn[want.nth] ?? inColumn.at(-1) ?? stops[0];
    show(row);
    if (!stop) return;
    wanted.current = undefined;
    stop.focus({ preventScroll: true });
  });
  useLayoutEffect(() => {
    const index = begin && indexOf.get(begin.key);
    const row = index === undefined ? undefined : rows[index];
    const edit = row && columns.find(({ id }) => id === begin?.column)?.edit?.(row);
    if (index === undefined || !edit) return;
    setActive({ row: index, column: begin?.column ?? '', nth: 0 });
    show(index);
    drafts.begin(edit);
  }, [begin]);

  const editable = columns.filter(({ edit }) => edit);
  const exit = (key: string, row: number, column: string, how: CellExit) => {
    if (how === 'nowhere') return;
    const [across, down] = STEPS[how];
    const at = editable.findIndex(({ id }) => id === column) + across;
    const beside = editable[at];
    if (beside) return goTo({ row, column: beside.id, nth: 0 }, key, down);
    // Behind the last cell of a row comes the first of the next one.
    const end = at < 0 ? editable.at(-1) : editable[0];
    goTo({ row, column: end?.id ?? column, nth: 0 }, key, across);
  };

  const press = (event: TargetedKeyboardEvent<HTMLElement>) => {
    const { key, ctrlKey, target } = event;
    const stop = target instanceof Element ? target.closest<HTMLElement>('[data-stop]') : null;
    const place = stop && placeOf(stop);
    if (!place) return;
    const row = rows[place.row];
    const edit = row && columns.find(({ id }) => id === place.column)?.edit?.(row);
    const stops = stopsIn(scroller.current, place.row);
    const step = { ArrowRight: 1, ArrowLeft: -1 }[key];
    const page = Math.max(1, Math.floor(view / line) - 1);
    const by = { ArrowDown: 1, ArrowUp: -1, PageDown: page, PageUp: -page }[key];
    const ends = { Home: 0, End: -1 }[key];
    if ((key === 'Enter' || key === 'F2') && edit) drafts.begin(edit);
    else if (step) stops[stops.indexOf(stop) + step]?.focus();
    else if (by) goTo({ ...place, row: Math.max(0, Math.min(rows.length - 1, place.row + by)) });
    else if (ends !== undefined && ctrlKey) goTo({ ...place, row: ends === 0 ? 0 : rows.length - 1 });
    else if (ends !== undefined) stops.at(ends)?.focus();
    else return;
    event.preventDefault();
  };
  const focused = ({ target }: TargetedEvent<HTMLElement, FocusEvent>) => {
    const place = target instanceof HTMLElement && target.closest<HTMLElement>('[data-stop]');
    const found = place ? placeOf(place) : undefined;
    if (found) setActive(found);
  };

  const tracks = cards ? {} : { gridTemplateColumns: columns.map(({ width }) => width).join(' ') };
  return (
    <div
      ref={scroller}
      class={`grid ${given}`}
      data-cards={cards ? '' : undefined}
      onScroll={({ currentTarget: { scrollTop } }) => setScrolled(scrollTop - (scrollTop % line))}
    >
      <table {...GRID} aria-label={label} aria-rowcount={rows.length + 1} aria-colcount={columns.length}>
        <thead {...GROUP}>
          <tr {...ROW} aria-rowindex={1} style={tracks}>
            {columns.map(({ id, name, head = name, sorted }) => (
              <th key={id} {...HEAD} scope="col" aria-sort={sorted} data-column={id}>
                {head}
              </th>
            ))}
          </tr>
        </thead>
        <tbody {...GROUP} style={{ height: `${topOf(all, rows.length)}px` }} onKeyDown={press} onFocusIn={focused}>
          {drawn.map((index) => {
            const row = rows[index];
            if (row === undefined) return null;
            const key = keyOf(row);
            const edits = editable.flatMap(({ edit }) => edit?.(row) ?? []);
            const isTall = keysBelow.has(key);
            return (
              <tr
                key={key}
                {...ROW}
                data-row={index}
                aria-rowindex={index + 2}
                style={{ top: `${topOf(all, index)}px`, ...tracks }}
              >
                {columns.map((column, at) => {
                  const { id, buttons, cell, edit: editOf } = column;
                  const edit = editOf?.(row);
                  const isActive = index === current && id === active.column;
                  const Cell = at === 0 ? 'th' : 'td';
                  const draft = edit && drafts.of(edit);
                  const begins = edit && !draft ? () => drafts.begin(edit) : undefined;
                  return (
                    <Cell
                      key={id}
                      {...(at === 0 ? ROW_HEAD : CELL)}
                      data-column={id}
                      {...(!buttons && !draft && { 'data-stop': '', tabIndex: isActive ? 0 : -1 })}
                      aria-readonly={edit ? undefined : true}
                      onDblClick={begins}
                      onClick={(event: MouseEvent) => {
                        if (begins && event instanceof PointerEvent && event.pointerType === 'touch') begins();
                      }}
                    >
                      {edit && draft ? (
                        <CellInput edit={edit} drafts={drafts} onExit={(how) => exit(key, index, id, how)} />
                      ) : (
                        cell(row, buttons && index !== current ? -1 : 0)
                      )}
                    </Cell>
                  );
                })}
                {isTall && (
                  <Below
                    onHeight={(height) =>
                      setHeights((before) =>
                        before.get(key) === height ? before : new Map([...before, [key, height]]),
                      )
                    }
                  >
                    {edits.map((edit) => (
                      <CellSaid key={edit.id} edit={edit} drafts={drafts} />
                    ))}
                    {below?.keys.includes(key) && below.of(row)}
                  </Below>
                )}
              </tr>
            );
          })}
        </tbody>
      </table>
    </div>
  );
}

/** What stands below the cells of a row; its height is told. */
function Below({
  onHeight,
  children,
}: {
  readonly onHeight: (height: number) => void;
  readonly children: ComponentChildren;
}) {
  const root = useRef<HTMLTableCellElement>(null);
  useSize(root, ({ offsetHeight }) => onHeight(offsetHeight));
  return (
    <td ref={root} {...CELL} class="below">
      {children}
    </td>
  );
}

const stopsIn = (box: Element | null, row: number) => [
  ...(box?.querySelectorAll<HTMLElement>(`tr[data-row="${row}"] [data-stop]`) ?? []),
];

const columnOf = (stop: Element) => stop.closest('[data-column]')?.getAttribute('data-column') ?? '';

function placeOf(stop: HTMLElement): Place | undefined {
  const row = stop.closest<HTMLElement>('tr[data-row]')?.dataset['row'];
  if (row === undefined) return undefined;
  const column = columnOf(stop);
  const inCell = stopsIn(stop.closest('tbody'), Number(row)).filter((other) => columnOf(other) === column);
  return { row: Number(row), column, nth: inCell.indexOf(stop) };
}
