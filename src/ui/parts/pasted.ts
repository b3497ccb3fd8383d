import { page } from './store.ts';

/** The text that was pasted into this window. */
export const { pasted } = page;

const TYPED_IN = 'input, textarea, select, [contenteditable]';

/** Takes text that is pasted outside of fields, and files and text that are dropped anywhere. */
export function takePastedText(): void {
  const take = ({ target }: Event, data: DataTransfer | null, always: 'files' | undefined) => {
    const file = data?.files[0];
    const typed = target instanceof Element && target.closest(TYPED_IN) !== null;
    // What comes into a field is typed there, but for a file that is dropped.
    if (typed && !(file && always)) return false;
    if (file) void file.text().then(pasted.take);
    else pasted.take(data?.getData('text/plain') ?? '');
    return true;
  };
  document.addEventListener('paste', (event) => take(event, event.clipboardData, undefined));
  document.addEventListener('dragover', (event) => {
    const types = event.dataTransfer?.types ?? [];
    if (types.includes('Files') || types.includes('text/plain')) event.preventDefault();
  });
  document.addEventListener('drop', (event) => {
    if (take(event, event.dataTransfer, 'files')) event.preventDefault();
  });
}
