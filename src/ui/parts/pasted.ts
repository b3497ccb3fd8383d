import { signal } from '@preact/signals';
import { looksLikeFrames } from '../../workbench/index.ts';
import { openInLog } from './for-log.ts';
import { fields, page } from './store.ts';

/** The text that was pasted into this window. */
export const { pasted } = page;

/** A frame or a log that was pasted into a field for a number, and the field, which stays as it was. */
interface Offered {
  readonly text: string;
  readonly field: HTMLElement;
}

export const offered = signal<Offered | undefined>(undefined);

const TYPED_IN = 'input, textarea, select, [contenteditable]';

/** Fields of the frame that take more than one number. */
const LONG: ReadonlySet<string> = new Set(['registers', 'bits', 'bytes', 'list', 'groups', 'rest']);

/** Takes text that is pasted outside of fields, and files and text that are dropped anywhere. */
export function takePastedText(): void {
  const take = (into: EventTarget | null, data: DataTransfer | null, always: 'files' | undefined) => {
    const file = data?.files[0];
    const typed = into instanceof Element && into.closest(TYPED_IN) !== null;
    // What comes into a field is typed there, but for a file that is dropped.
    if (typed && !(file && always)) return false;
    if (file) void openFile(file);
    else pasted.take(data?.getData('text/plain') ?? '');
    return true;
  };
  document.addEventListener('paste', (event) => {
    const text = event.clipboardData?.getData('text/plain') ?? '';
    // A click beside a field leaves Chromium's caret in it, and with it the target, but what is pasted does not come there.
    const { activeElement: into } = document;
    if (isForNumber(into) && looksLikeFrames(text)) {
      event.preventDefault();
      offered.value = { text, field: into };
    } else take(into, event.clipboardData, undefined);
  });
  document.addEventListener('dragover', (event) => {
    const types = event.dataTransfer?.types ?? [];
    if (types.includes('Files') || types.includes('text/plain')) event.preventDefault();
  });
  document.addEventListener('drop', (event) => {
    if (take(event.target, event.dataTransfer, 'files')) event.preventDefault();
  });
}

/** Longer files, in bytes, are logs. */
const LARGE = 50_000;

/** Reads a file: a short text as if it were pasted. Any other in the Log view, which says so if it is empty or cannot be read. */
export async function openFile(file: File): Promise<void> {
  const text = file.size === 0 || file.size > LARGE ? '\0' : await file.text().catch(() => '\0');
  // Neither character is in a text: the second stands for bytes that are none.
  if (/[\0\ufffd]/.test(text)) openInLog(file);
  else pasted.take(text, file.name);
}

/** Whether an element is a field of the frame that takes one number. */
function isForNumber(target: EventTarget | null): target is HTMLInputElement {
  if (!(target instanceof HTMLInputElement)) return false;
  const path = /^f-(.+)$/.exec(target.id)?.[1];
  const kind = path && fields.at(path).control.peek() && fields.at(path).field.peek()?.kind;
  return path === 'unitId' || path === 'transactionId' || (!!kind && !LONG.has(kind));
}
