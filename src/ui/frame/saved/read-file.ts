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
