import type { TargetedKeyboardEvent } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import type { Span } from '../../../modbus/index.ts';
import { worst } from '../../../workbench/index.ts';
import { useSteady } from '../steady.ts';
import { useWords } from '../words.ts';
import { Cells, focusByte } from './byte-cells.tsx';
import { drawnOf, isLong, type StripState } from './strip-state.ts';

interface StripProps {
  readonly strip: StripState;
}

/** What a byte is typed with: what begins to type replaces it. */
const DIGIT = /^[\dA-Fa-f]$/;

/** The frame as the wire carries it: every byte a cell in the colour of its field, under each field what it means. */
export function StripFields({ strip }: StripProps) {
  const { page: words } = useWords('page');
  const spans = useSteady(() => strip.of.value?.reading.spans ?? [], [strip]).value;
  // The byte that had the focus before a click; a click on it types.
  const before = useRef<number | undefined>(undefined);
  const list = useRef<HTMLOListElement>(null);
  // With another frame the byte that has the focus may be gone.
  const hadFocus = list.current?.contains(document.activeElement);
  useLayoutEffect(() => {
    if (hadFocus && list.current && !list.current.contains(document.activeElement)) focusByte(list.current);
  });
  const press = (event: TargetedKeyboardEvent<HTMLElement>) => {
    const cell = cellOf(event.target);
    if (cell === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    const to = cellForKey(event.key, cell, event.currentTarget);
    if (to) {
      event.preventDefault();
      to.focus();
    } else if (strip.edit && (event.key === 'Enter' || event.key === 'F2' || DIGIT.test(event.key))) {
      if (cell.dataset['fold'] !== undefined) return;
      // A digit is no command of the page here.
      event.preventDefault();
      type(cell, DIGIT.test(event.key) ? event.key.toUpperCase() : undefined);
    }
  };
  const type = (cell: HTMLElement, text = cell.firstChild?.textContent ?? '') => {
    strip.editing.value = { at: Number(cell.dataset['from']), text };
  };
  return (
    <ol
      ref={list}
      class="strip-fields"
      aria-label={words.bytes}
      onKeyDown={press}
      onFocusIn={({ target }) => {
        const cell = cellOf(target);
        if (cell) strip.at.value = Number(cell.dataset['from']);
      }}
      onPointerDown={() => {
        before.current = document.activeElement instanceof HTMLElement ? fromOf(document.activeElement) : undefined;
      }}
      onClick={({ target }) => {
        const cell = cellOf(target);
        if (cell === undefined || cell.dataset['fold'] !== undefined) return;
        cell.focus();
        if (strip.edit && before.current === fromOf(cell)) type(cell);
      }}
    >
      {spans.map((span) => (
        <StripField key={`${span.name}-${span.from}`} strip={strip} span={span} />
      ))}
    </ol>
  );
}

const cellOf = (target: EventTarget | null): HTMLElement | undefined =>
  target instanceof HTMLElement ? (target.closest<HTMLElement>('button.byte') ?? undefined) : undefined;

const fromOf = (cell: HTMLElement) => (cell.matches('button.byte') ? Number(cell.dataset['from']) : undefined);

/** The cell a key leads to: arrows go by one, or by a field; `undefined` for keys that lead nowhere. */
function cellForKey(key: string, cell: HTMLElement, list: HTMLElement): HTMLElement | undefined {
  const cells = [...list.querySelectorAll<HTMLElement>('button.byte')];
  const at = cells.indexOf(cell);
  if (key === 'ArrowRight' || key === 'ArrowLeft') return cells[at + (key === 'ArrowRight' ? 1 : -1)] ?? cell;
  if (key === 'Home') return cells[0];
  if (key === 'End') return cells.at(-1);
  if (key !== 'ArrowDown' && key !== 'ArrowUp') return undefined;
  const field = cell.closest('li');
  const other = key === 'ArrowDown' ? field?.nextElementSibling : field?.previousElementSibling;
  return other?.querySelector<HTMLElement>('button.byte') ?? cell;
}

interface FieldProps extends StripProps {
  readonly span: Span;
}

function StripField({ strip, span }: FieldProps) {
  const words = useWords('page');
  const { name, kind, from, to } = span;
  const severity = useSteady(() => {
    const problems = strip.of.value?.reading.problems ?? [];
    return worst(problems.filter((problem) => problem.span.from < to && problem.span.to > from));
  }, [strip, span]).value;
  const folded = strip.folded.value;
  const label = words.labels[name] ?? name;
  const { head, tail } = drawnOf(span, folded);
  return (
    <li class="strip-field" data-kind={kind} data-severity={severity}>
      <span class="name" title={label}>
        {severity && (
          <b class="mark">
            <span aria-hidden="true">{severity === 'note' ? 'i' : '!'}</span>
            <span class="unseen">{words.page.severities[severity]}: </span>
          </b>
        )}
        {words.short[name] ?? label.toLowerCase()}
        {isLong(span) && !folded && (
          <button
            type="button"
            class="fold"
            aria-label={words.strip.foldField(label)}
            onClick={() => {
              strip.folded.value = true;
            }}
          >
            {words.strip.fold}
          </button>
        )}
      </span>
      <span class="bytes">
        <Cells strip={strip} span={span} from={from} to={head} />
        {head < tail && (
          <>
            <Folded strip={strip} span={span} from={head} to={tail} />
            <Cells strip={strip} span={span} from={tail} to={to} />
          </>
        )}
      </span>
      <Note strip={strip} span={span} />
    </li>
  );
}

interface FoldedProps extends FieldProps {
  readonly from: number;
  readonly to: number;
}

/** Bytes in the middle of a long run: the button shows them, as far as so many can be drawn. */
function Folded({ strip, span, from, to }: FoldedProps) {
  const words = useWords('page');
  const can = strip.folded.value;
  return (
    <button
      type="button"
      class="byte folded"
      data-fold=""
      data-from={from}
      data-to={to}
      tabIndex={-1}
      aria-label={words.strip.showAll(words.labels[span.name] ?? span.name, to - from)}
      onClick={() => {
        if (can) strip.folded.value = false;
      }}
    >
      …<small>{words.strip.more(to - from)}</small>
    </button>
  );
}

/** What the field means here, in few words. */
function Note({ strip, span }: FieldProps) {
  const { strip: words } = useWords('page');
  const text = useSteady(() => {
    const { value: of } = strip.of;
    return of
      ? words.note({ reading: of.reading, span, named: of.names?.short(span.name) ?? '', sixDigits: of.sixDigits })
      : '';
  }, [strip, span, words]).value;
  return <span class="note">{text}</span>;
}
