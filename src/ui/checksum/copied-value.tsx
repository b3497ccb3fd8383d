import { signal } from '@preact/signals';
import { putOnClipboard } from '../kit/clipboard.ts';
import { checksumWords as words } from './checksum-words.ts';

/** What was copied last, said once for the whole view. */
export const copied = signal<string>('');

/** How long it is shown, in milliseconds. */
const SHOWN_FOR = 5000;

/** Puts a text on the clipboard, and says so; where the browser refuses, the text itself is said. */
export async function copy(text: string, what: string): Promise<void> {
  const said = (await putOnClipboard(text)) ? words.copied(what) : `${words.copyFailed} ${text}`;
  copied.value = said;
  setTimeout(() => {
    if (copied.value === said) copied.value = '';
  }, SHOWN_FOR);
}

/** A value that is copied by pressing it. */
export function CopiedValue({ text, of }: { readonly text: string; readonly of: string }) {
  return (
    <button type="button" class="value mono" aria-label={words.copy(text, of)} onClick={() => void copy(text, text)}>
      {text}
    </button>
  );
}
