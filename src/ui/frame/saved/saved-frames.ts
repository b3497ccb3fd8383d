import { SavedFrames } from '../../../store/index.ts';
import type { WordsOf } from '../../../words/index.ts';
import { readSaved } from '../../../workbench/index.ts';
import { storage } from '../../parts/store.ts';
import { importLines, refusalText } from './saved-messages.ts';

/** The frames kept in this browser. */
export const savedFrames = new SavedFrames(storage);

/** A list of frames is small; anything bigger is another file chosen by mistake. */
const LARGEST = 5_000_000;

/** Imports a file that a person chose. Answers the result in sentences. */
export async function importFile(file: File, words: WordsOf<'saved'>): Promise<readonly string[]> {
  if (file.size > LARGEST) return [words.fileTooBig(file.name)];
  const text = await file.text().catch(() => undefined);
  if (text === undefined) return [words.fileUnread(file.name)];
  const reading = readSaved(text);
  if (reading.kind === 'unreadable') return [words.badFile(file.name, reading.fault)];
  const imported = savedFrames.import(reading.frames);
  const bad = reading.bad.map(({ row, why }) => words.badRow(row, why));
  return [
    ...(typeof imported === 'string' ? [refusalText(words, imported, file.name)] : importLines(words, imported)),
    ...bad,
  ];
}
