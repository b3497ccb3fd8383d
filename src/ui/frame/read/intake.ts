import { opened, read } from '../../parts/pasted.ts';

const TYPED_IN = 'input, textarea, select, [contenteditable]';

/** Reads what is pasted outside of fields, and files and text that are dropped anywhere. */
export function takeIn(): void {
  const take = (text: string) => {
    if (text.trim() === '') return;
    opened.value = true;
    read(text, 'step');
  };
  document.addEventListener('paste', (event) => {
    if (event.target instanceof Element && event.target.closest(TYPED_IN)) return;
    const file = event.clipboardData?.files[0];
    if (file) void file.text().then(take);
    else take(event.clipboardData?.getData('text/plain') ?? '');
  });
  document.addEventListener('dragover', (event) => {
    const types = event.dataTransfer?.types ?? [];
    if (types.includes('Files') || types.includes('text/plain')) event.preventDefault();
  });
  document.addEventListener('drop', (event) => {
    const file = event.dataTransfer?.files[0];
    // Text dropped into a field is typed there.
    if (!file && event.target instanceof Element && event.target.closest(TYPED_IN)) return;
    event.preventDefault();
    if (file) void file.text().then(take);
    else take(event.dataTransfer?.getData('text/plain') ?? '');
  });
}
