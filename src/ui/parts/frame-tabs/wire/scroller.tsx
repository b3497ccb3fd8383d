import type { Signal } from '@preact/signals';
import type { ComponentChildren, RefObject } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';
import { dictionary } from '../../../../modbus/index.ts';
import {
  type Scene,
  type StripView,
  viewAfter,
  viewAtWidth,
  viewOf,
  viewOfBit,
  viewWithin,
  zoomed,
  zoomTargets,
} from '../../../../workbench/index.ts';
import { relight } from '../../lit.ts';
import { useWords } from '../../words.ts';
import { GUTTER } from './picture/picture.tsx';

interface ScrollerProps {
  readonly scene: Scene;
  /** What is in sight. Set here by scrolling and zooming, and from outside to show something. */
  readonly view: Signal<StripView>;
  /** Draws what is in sight. */
  readonly draw: (view: StripView) => ComponentChildren;
  /** The element that scrolls. */
  readonly strip: RefObject<HTMLElement | null>;
}

/** What a step of the zoom multiplies by. */
const STEP = 1.4;

/** The line as a strip that scrolls like any other, of which only what is in sight is drawn. */
export function Scroller({ scene, view, draw, strip }: ScrollerProps) {
  const words = useWords('wire');
  const shown = view.value;
  const { width, px, from } = shown;
  const { line } = scene;
  const latest = useRef(scene);
  /** The view to which the strip is scrolled. */
  const placed = useRef(shown);
  const show = (next: StripView) => {
    view.value = next;
  };
  const zoom = (factor: number, at?: number) => show(zoomed(line, view.peek(), factor, at));
  useLayoutEffect(() => {
    const element = strip.current;
    if (element === null) return;
    const measure = () => {
      const wide = Math.max(0, element.clientWidth - GUTTER);
      if (wide !== view.peek().width) show(viewAtWidth(latest.current, view.peek(), wide));
    };
    const wheel = (event: WheelEvent) => {
      if (!event.ctrlKey) return;
      event.preventDefault();
      const at = Math.max(0, event.clientX - element.getBoundingClientRect().left - GUTTER);
      show(zoomed(latest.current.line, view.peek(), event.deltaY < 0 ? STEP : 1 / STEP, at));
    };
    const resize = new ResizeObserver(measure);
    resize.observe(element);
    element.addEventListener('wheel', wheel, { passive: false });
    measure();
    return () => {
      resize.disconnect();
      element.removeEventListener('wheel', wheel);
    };
  }, []);
  useLayoutEffect(() => {
    if (width > 0) show(viewAfter(latest.current, scene, view.peek()));
    latest.current = scene;
  }, [scene]);
  useLayoutEffect(() => {
    if (strip.current && shown !== placed.current) strip.current.scrollLeft = from * px;
    placed.current = shown;
    relight();
  });
  const keys: Readonly<Record<string, () => void>> = dictionary({
    '+': () => zoom(STEP),
    '=': () => zoom(STEP),
    '-': () => zoom(1 / STEP),
    '0': () => show(viewOf(scene, view.peek(), 'all')),
    Home: () => show(viewWithin(line, { ...view.peek(), from: 0 })),
    End: () => show(viewWithin(line, { ...view.peek(), from: line.end })),
  });
  return (
    <>
      <fieldset class="zoom in-row" aria-label={words.zoom}>
        <button type="button" aria-label={words.zoomOut} title={words.zoomOut} onClick={() => zoom(1 / STEP)}>
          −
        </button>
        <button type="button" aria-label={words.zoomIn} title={words.zoomIn} onClick={() => zoom(STEP)}>
          +
        </button>
        {zoomTargets.map((target) => (
          <button
            key={target}
            type="button"
            title={words.zoomHints[target]}
            onClick={() => show(viewOf(scene, view.peek(), target))}
          >
            {words.zoomTo[target]}
          </button>
        ))}
        <span class="said">{words.zoomHint}</span>
      </fieldset>
      <section
        class="strip-of-line"
        aria-label={words.view}
        // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls has to be reached by the keyboard
        tabIndex={0}
        ref={strip}
        onKeyDown={(event) => {
          const act = keys[event.key];
          if (act === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
          event.preventDefault();
          act();
        }}
        onClick={({ clientX, currentTarget }) =>
          show(viewOfBit(scene, view.peek(), clientX - currentTarget.getBoundingClientRect().left - GUTTER))
        }
        onScroll={({ currentTarget }) => {
          const now = view.peek();
          const start = currentTarget.scrollLeft / now.px;
          // Scrolling rounds to whole pixels; the place that was asked for stays exact.
          if (Math.abs(start - now.from) * now.px < 1) return;
          placed.current = { ...now, from: start };
          show(placed.current);
        }}
      >
        <div class="whole-line" style={{ '--whole': `${GUTTER + Math.ceil(line.end * px)}px` }}>
          {width > 0 && px > 0 && draw(shown)}
        </div>
      </section>
    </>
  );
}
