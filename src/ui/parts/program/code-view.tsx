import { useEffect, useLayoutEffect, useMemo, useRef } from 'preact/hooks';
import type { ByteRange } from '../../../workbench/index.ts';
import { relight } from '../lit.ts';
import { type Code, useCode } from '../slot.tsx';
import { useWords } from '../words.ts';
import { type Highlight, plainLines } from './highlight.ts';

/** The bytes that a line stands for, and the kind of field they are. */
export interface LineBytes extends ByteRange {
  readonly kind: string;
}

/** What is said of a line, below it. */
export interface LineNote {
  readonly text: string;
  readonly severity: 'error' | 'warning';
}

interface CodeViewProps {
  readonly label: string;
  readonly text: string;
  readonly highlighting: Code<Highlight>;
  /** By the line's number, from 1. */
  readonly bytes?: ReadonlyMap<number, LineBytes>;
  readonly notes?: ReadonlyMap<number, LineNote>;
}

/** Characters of a text that are drawn: of a frame of tens of thousands of bytes, each is a number in the program. */
const DRAWN = 50_000;

/** The whole lines of a text that are drawn, and how many lines are left out. */
function drawnPart(text: string): { readonly drawn: string; readonly left: number } {
  const end = text.length > DRAWN ? text.indexOf('\n', DRAWN) : -1;
  if (end < 0) return { drawn: text, left: 0 };
  return { drawn: text.slice(0, end), left: text.slice(end + 1).split('\n').length };
}

/** A text of a program, highlighted once its language has come. Lines that stand for bytes of the frame light them. */
export function CodeView({ label, text, highlighting, bytes, notes }: CodeViewProps) {
  const box = useRef<HTMLElement>(null);
  const highlight = useCode(highlighting, true);
  const words = useWords('program');
  const { drawn, left } = useMemo(() => drawnPart(text.replace(/\n$/, '')), [text]);
  const lines = useMemo(() => (highlight ?? plainLines)(drawn), [drawn, highlight]);
  // What is lit stays lit on the lines that are new.
  useLayoutEffect(() => relight(), [lines, bytes]);
  useShownLines(box);
  return (
    // biome-ignore lint/a11y/noNoninteractiveTabindex: what scrolls inside itself is reached by keys.
    <section ref={box} class="code" tabIndex={0} aria-label={label}>
      <pre>
        {lines.map((tokens, index) => {
          const range = bytes?.get(index + 1);
          const note = notes?.get(index + 1);
          return (
            <span key={index} class="code-line" data-kind={range?.kind} data-from={range?.from} data-to={range?.to}>
              {tokens.map(({ text: part, scope }, at) =>
                scope === '' ? (
                  part
                ) : (
                  <span key={at} data-token={scope}>
                    {part}
                  </span>
                ),
              )}
              {'\n'}
              {note && (
                <span class="code-note" data-severity={note.severity}>
                  {note.text}
                  {'\n'}
                </span>
              )}
            </span>
          );
        })}
      </pre>
      {left > 0 && <p class="said">{words.linesLeft(left)}</p>}
    </section>
  );
}

/** Scrolls the box to the lines of a byte that gets the focus elsewhere, where none of them is in sight. */
function useShownLines(box: { readonly current: HTMLElement | null }): void {
  useEffect(() => {
    const show = ({ target }: FocusEvent) => {
      const { current } = box;
      if (!current || !(target instanceof Element) || current.contains(target)) return;
      if (target.closest('[data-from]') === null) return;
      const { top, bottom } = current.getBoundingClientRect();
      const lit = [...current.querySelectorAll('.code-line[data-lit]')].map((line) => line.getBoundingClientRect());
      const [first] = lit;
      if (first === undefined || lit.some((line) => line.top >= top && line.bottom <= bottom)) return;
      current.scrollTop += first.top - top - current.clientHeight / 3;
    };
    document.addEventListener('focusin', show);
    return () => document.removeEventListener('focusin', show);
  }, []);
}
