import type { ComponentChildren } from 'preact';
import { useEffect, useState } from 'preact/hooks';
import { putOnClipboard } from './clipboard.ts';
import './copy-button.css';

/** Milliseconds for which it is said that something was copied. */
const SAID = 2000;

/** What is put on the clipboard: a text, or a picture that is still in the making. */
type Content = string | Promise<Blob>;

interface Outcome {
  readonly id: string;
  readonly of: unknown;
  /** The text that the browser refused. */
  readonly refused?: string;
}

/**
 * Copies texts, and remembers for a while which of them, named by an id, was copied. What was said of one thing (`of`) is not
 * said of another.
 */
export function useCopying(of: unknown) {
  const [last, setLast] = useState<Outcome>();
  useEffect(() => {
    if (last === undefined || last.refused !== undefined) return;
    const ends = setTimeout(() => setLast(undefined), SAID);
    return () => clearTimeout(ends);
  }, [last]);
  const said = last?.of === of ? last : undefined;
  return {
    copy: (id: string, content: Content) =>
      void putOnClipboard(content).then((done) =>
        setLast({ id, of, ...(!done && { refused: typeof content === 'string' ? content : '' }) }),
      ),
    /** The id of what was copied just now. */
    copied: said?.refused === undefined ? said?.id : undefined,
    /** The text that the browser did not let copy. */
    refused: said?.refused,
  };
}

interface InPlaceProps {
  readonly said: boolean;
  /** What is said in the place of the label. */
  readonly word: string;
  readonly children: ComponentChildren;
}

/** A label in the place of which something is said for a while: nothing changes its size. */
export const InPlace = ({ said, word, children }: InPlaceProps) => (
  <span class="in-place" data-said={said ? '' : undefined}>
    <span>{children}</span>
    <span>{word}</span>
  </span>
);

interface CopyingProps {
  /** What is said once a text is on the clipboard. */
  readonly copied: string;
  /** What is said if the browser refuses, of the text that was to be copied. */
  readonly refused: (text: string) => string;
  /** What the texts are of: what was said of one thing is not said of another. */
  readonly of: unknown;
  /** The buttons; `copy` makes the handler of one from what makes its text. */
  readonly children: (copy: (text: () => string) => () => void) => ComponentChildren;
}

/** Buttons that copy texts, and one place that says for a while what became of it. */
export function Copying({ copied, refused, of, children }: CopyingProps) {
  const copying = useCopying(of);
  return (
    <>
      {children((text) => () => copying.copy('', text()))}{' '}
      <output>{copying.refused !== undefined ? refused(copying.refused) : copying.copied === '' && copied}</output>
    </>
  );
}

interface CopyButtonProps extends Omit<CopyingProps, 'children'> {
  readonly label: string;
  /** Its name for those who hear the page, if there are several: what it copies. */
  readonly name?: string;
  /** What is copied; made when the button is pressed. */
  readonly text: () => string;
}

/** A button that copies a text, and says in its own place that it did. */
export function CopyButton({ label, name, text, copied, refused, of }: CopyButtonProps) {
  const copying = useCopying(of);
  return (
    <span class="copy-button">
      <button
        type="button"
        aria-label={name && copying.copied === '' ? copied : name}
        onClick={() => copying.copy('', text())}
      >
        <InPlace said={copying.copied === ''} word={copied}>
          {label}
        </InPlace>
      </button>
      <output class={copying.refused === undefined ? 'unseen' : ''}>
        {copying.refused !== undefined ? refused(copying.refused) : copying.copied !== undefined && copied}
      </output>
    </span>
  );
}
