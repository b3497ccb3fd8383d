import { signal } from '@preact/signals';
import { useEffect } from 'preact/hooks';
import { putOnClipboard } from '../kit/clipboard.ts';
import { useWords } from '../parts/words.ts';

/** What was to be copied last, as it is called, and the text itself if the browser refused. */
const last = signal<{ readonly name: string; readonly refused?: string } | undefined>(undefined);

/** How long it is said what was copied, in milliseconds. */
const SHOWN_FOR = 5000;

/** Puts a text on the clipboard, and has that said under a name; if the browser refuses, the text itself is said. */
export async function copy(text: string, name = text): Promise<void> {
  const said = (await putOnClipboard(text)) ? { name } : { name, refused: text };
  last.value = said;
  setTimeout(() => {
    if (last.value === said) last.value = undefined;
  }, SHOWN_FOR);
}

/** Says what was copied last, once for the whole view. */
export function Copied() {
  const words = useWords('checksum');
  useEffect(
    () => () => {
      last.value = undefined;
    },
    [],
  );
  const { name, refused } = last.value ?? {};
  return (
    <output class="copied">
      {refused === undefined ? name !== undefined && words.copied(name) : `${words.copyFailed} ${refused}`}
    </output>
  );
}

/** A value that is copied by pressing it. */
export function CopiedValue({ text, of }: { readonly text: string; readonly of: string }) {
  const words = useWords('checksum');
  return (
    <button type="button" class="value mono" aria-label={words.copy(text, of)} onClick={() => void copy(text)}>
      {text}
    </button>
  );
}
