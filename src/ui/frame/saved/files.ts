import { type BadRow, type FileFault, readSaved, type SavedFrame } from '../../../workbench/index.ts';

/** A list of frames is small; anything bigger is another file chosen by mistake. */
const LARGEST = 5_000_000;

export type FileOutcome =
  | { readonly kind: 'list'; readonly frames: readonly SavedFrame[]; readonly bad: readonly BadRow[] }
  | { readonly kind: 'unreadable'; readonly fault: FileFault }
  | { readonly kind: 'too-big' }
  | { readonly kind: 'unread' };

/** Reads a file that a person chose. */
export async function readFile(file: File): Promise<FileOutcome> {
  if (file.size > LARGEST) return { kind: 'too-big' };
  const text = await file.text().catch(() => undefined);
  return text === undefined ? { kind: 'unread' } : readSaved(text);
}

/** Hands a text or bytes to the person as a file. */
export function download(content: string | Uint8Array<ArrayBuffer>, name: string, type = 'application/json'): void {
  const link = document.createElement('a');
  link.href = URL.createObjectURL(new Blob([content], { type }));
  link.download = name;
  link.click();
  // The browser takes the text up only after this; a minute is time enough.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}
