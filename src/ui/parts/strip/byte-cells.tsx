import { useLayoutEffect, useRef } from 'preact/hooks';
import { type Span, toHex } from '../../../modbus/index.ts';
import { character, typedByte } from '../../../workbench/index.ts';
import { useSteady } from '../steady.ts';
import { useWords } from '../words.ts';
import type { StripState } from './strip-state.ts';

interface CellsProps {
  readonly strip: StripState;
  readonly span: Span;
  readonly from: number;
  readonly to: number;
}

/** Cells that are drawn together: a character typed changes few bytes. */
const RUN = 16;

/** The bytes from `from` to `to` of a field. */
export const Cells = ({ strip, span, from, to }: CellsProps) => (
  <>
    {Array.from({ length: Math.ceil((to - from) / RUN) }, (_, index) => from + index * RUN).map((at) => (
      <Run key={at} strip={strip} span={span} from={at} to={Math.min(at + RUN, to)} />
    ))}
  </>
);

function Run({ strip, span, from, to }: CellsProps) {
  const words = useWords('page');
  const shown = useSteady(() => {
    const { reading, bytes } = strip.of.value ?? {};
    const length = bytes?.length ?? 0;
    // Where the frame has become shorter, its first byte has the Tab key.
    const here = strip.at.value < length ? strip.at.value : 0;
    const edited = strip.editing.value;
    return {
      hex: bytes ? toHex(bytes, from, to) : '',
      isAscii: reading?.transport === 'ascii',
      here: here >= from && here < to ? here : undefined,
      edited: edited && edited.at >= from && edited.at < to ? edited : undefined,
    };
  }, [strip, from, to]).value;
  const label = words.labels[span.name] ?? span.name;
  return (
    <>
      {(shown.hex.match(/../g) ?? []).map((pair, index) => {
        const at = from + index;
        if (shown.edited?.at === at) {
          return <TypedByte key={at} strip={strip} at={at} text={shown.edited.text} isAscii={shown.isAscii} />;
        }
        const text = shown.isAscii ? character(Number.parseInt(pair, 16)) : pair;
        return (
          <button
            type="button"
            class="byte"
            key={at}
            data-from={at}
            data-to={at + 1}
            tabIndex={shown.here === at ? 0 : -1}
            aria-label={words.strip.byteName(at, text, label)}
          >
            {text}
            <small data-below={shown.isAscii ? pair : at} />
          </button>
        );
      })}
    </>
  );
}

/** Gives the focus to the byte that the Tab key comes to. */
export const focusByte = (list: Element) => list.querySelector<HTMLElement>('[tabindex="0"]')?.focus();

interface TypedByteProps {
  readonly strip: StripState;
  readonly at: number;
  readonly text: string;
  readonly isAscii: boolean;
}

/** A byte while it is typed: Enter, Tab and leaving it take it, Escape gives the old one back. */
function TypedByte({ strip, at, text, isAscii }: TypedByteProps) {
  const words = useWords('page').strip;
  const input = useRef<HTMLInputElement>(null);
  useLayoutEffect(() => {
    const { current } = input;
    current?.focus();
    // A digit that begins is followed by the next; a byte that was there is replaced.
    current?.setSelectionRange(text.length === 2 ? 0 : text.length, text.length);
  }, []);
  const end = (take: boolean, list?: Element | null) => {
    if (strip.editing.peek() === undefined) return;
    const value = take ? typedByte(input.current?.value ?? '', isAscii ? 'ascii' : 'rtu') : undefined;
    strip.editing.value = undefined;
    if (value !== undefined) strip.edit?.(at, value);
    // The cell is drawn again before the focus comes back to it.
    if (list) setTimeout(() => focusByte(list));
  };
  return (
    <input
      ref={input}
      class="byte"
      data-from={at}
      data-to={at + 1}
      aria-label={words.editByte(at)}
      defaultValue={text}
      maxLength={2}
      autocomplete="off"
      autocapitalize="characters"
      spellcheck={false}
      onBlur={() => end(true)}
      onKeyDown={(event) => {
        const { key, currentTarget } = event;
        const isOfPage = /^F\d/.test(key);
        const isTaken = key === 'Enter' || key === 'Escape';
        if (isTaken || isOfPage) end(key !== 'Escape', currentTarget.closest('.strip-fields'));
        // What was typed is taken before the page shows another frame.
        if (isOfPage) return;
        event.stopPropagation();
        if (isTaken) event.preventDefault();
      }}
    />
  );
}
