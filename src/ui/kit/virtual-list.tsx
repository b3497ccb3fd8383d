import type { ComponentChildren, RefObject, TargetedEvent, TargetedWheelEvent } from 'preact';
import { useLayoutEffect, useRef, useState } from 'preact/hooks';
import { type LineBox, lineForKey, linesInSight, scrollHeight, scrollScale, scrollToLine } from './line-window.ts';
import { useSize } from './use-size.ts';
import './virtual-list.css';

interface LinesOptions {
  readonly count: number;
  /** The height of a line, in pixels; the style sheet has the same. */
  readonly line: number;
  /** The height of a head that stays above the lines. */
  readonly head?: number;
}

/** Of a long list the lines in sight, and what the element needs that scrolls them. */
export function useVirtualLines<E extends HTMLElement>({ count, line, head = 0 }: LinesOptions) {
  const element = useRef<E>(null);
  const [scrolled, setScrolled] = useState(0);
  const [view, setView] = useState(0);
  const box: LineBox = { count, line, view };
  const viewOf = ({ clientHeight }: E) => Math.max(0, clientHeight - head);

  useSize(element, (current) => setView(viewOf(current)), [head]);

  const { from, to, origin } = linesInSight(box, scrolled);
  return {
    /** For the element that scrolls. */
    scroller: {
      ref: element as RefObject<E>,
      // Lines that move with the box are drawn again only when others come into sight.
      onScroll: ({ currentTarget: { scrollTop } }: TargetedEvent<E>) =>
        setScrolled(scrollScale(box) === 1 ? scrollTop - (scrollTop % line) : scrollTop),
      onWheel: (event: TargetedWheelEvent<E>) => {
        const scale = scrollScale(box);
        if (scale === 1 || event.deltaMode !== WheelEvent.DOM_DELTA_PIXEL) return;
        event.preventDefault();
        event.currentTarget.scrollTop += event.deltaY / scale;
      },
    },
    /** Whether the element has a place on the screen: what is scrolled while it is hidden is lost. */
    inSight: view > 0,
    /** The height of the element that holds the lines. */
    height: scrollHeight(box),
    /** The lines to be drawn, each with its distance from the top of that element. */
    lines: Array.from({ length: to - from }, (_, at) => ({ index: from + at, top: origin + (from + at) * line })),
    /** Brings a line into sight. */
    show: (index: number) => {
      const { current } = element;
      if (current) current.scrollTop = scrollToLine({ count, line, view: viewOf(current) }, current.scrollTop, index);
    },
    /** Where a key leads from a line; `undefined` for keys that lead nowhere. */
    placeFor: (key: string, from: number) => lineForKey(key, box, from),
  };
}

interface ListProps {
  /** The beginning of the ids of its lines. */
  readonly id: string;
  readonly label: string;
  readonly class?: string;
  /** In a list narrower than this, in pixels, a line has two lines of text: the style sheet draws them by `data-lines`. */
  readonly breaksBelow?: number;
  readonly count: number;
  readonly chosen: number;
  /** A line was chosen: by the keys that move through the list, or by a click. */
  readonly onChoose: (index: number, by: 'key' | 'click') => void;
  /** Enter was pressed. */
  readonly onEnter?: (index: number) => void;
  readonly onLeave?: () => void;
  /** Keeps the last line in sight while lines are added. */
  readonly follow?: boolean;
  /** What the lines are of: another list begins at its top. */
  readonly of?: unknown;
  /** Attributes of a line, for style sheets. */
  readonly attributes?: (index: number) => Readonly<Record<`data-${string}`, string | undefined>>;
  /** Draws a line. */
  readonly children: (index: number) => ComponentChildren;
}

/** The height of a line, by the lines of text in it. */
const HEIGHTS = { 1: 32, 2: 48 } as const;

/** A long list of which only the lines in sight are drawn. Arrows, Home, End and the Page keys choose. */
export function VirtualList(props: ListProps) {
  const {
    id,
    label,
    class: given = '',
    breaksBelow = 0,
    count,
    onChoose,
    onEnter,
    onLeave,
    follow,
    of,
    attributes,
    children,
  } = props;
  const chosen = Math.min(props.chosen, count - 1);
  const [text, setText] = useState<1 | 2>(1);
  const list = useVirtualLines<HTMLDivElement>({ count, line: HEIGHTS[text] });
  const { scroller, lines, height, inSight, show, placeFor } = list;
  useSize(
    scroller.ref,
    ({ clientWidth }) => {
      // A list that is hidden has no width.
      if (breaksBelow > 0 && clientWidth > 0) setText(clientWidth < breaksBelow ? 2 : 1);
    },
    [breaksBelow],
  );

  useLayoutEffect(() => show(0), [of]);
  useLayoutEffect(() => {
    if (inSight && chosen >= 0) show(chosen);
  }, [chosen, inSight, text]);
  useLayoutEffect(() => {
    if (follow && count > 0) show(count - 1);
  }, [follow, count, text]);

  const go = (event: KeyboardEvent) => {
    if (event.key === 'Enter' && chosen >= 0) onEnter?.(chosen);
    const index = placeFor(event.key, chosen);
    if (index === undefined || count === 0) return;
    event.preventDefault();
    onChoose(index, 'key');
  };
  const click = ({ target }: MouseEvent) => {
    const line = target instanceof Element ? target.closest<HTMLElement>('[data-index]') : null;
    if (line) onChoose(Number(line.dataset['index']), 'click');
  };
  return (
    <div
      {...scroller}
      class={`virtual-list ${given}`}
      data-lines={text}
      role="listbox"
      aria-label={label}
      aria-activedescendant={lines.some(({ index }) => index === chosen) ? `${id}-${chosen}` : undefined}
      tabIndex={0}
      onKeyDown={go}
      onClick={click}
      onBlur={onLeave}
    >
      <div style={{ height: `${height}px` }} role="presentation">
        {lines.map(({ index, top }) => (
          <div
            {...attributes?.(index)}
            // A line that comes into sight takes the element of one that leaves it.
            key={index % lines.length}
            id={`${id}-${index}`}
            role="option"
            tabIndex={-1}
            data-index={index}
            aria-selected={index === chosen}
            aria-posinset={index + 1}
            aria-setsize={count}
            style={{ transform: `translateY(${top}px)` }}
          >
            {children(index)}
          </div>
        ))}
      </div>
    </div>
  );
}
