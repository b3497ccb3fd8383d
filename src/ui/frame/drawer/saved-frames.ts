import { computed } from '@preact/signals';
import { type Naming, SavedFrames } from '../../../store/index.ts';
import type { WordsOf } from '../../../words/index.ts';
import { type Draft, readSaved } from '../../../workbench/index.ts';
import { step, storage } from '../../parts/store.ts';

/** The frames kept in this browser. */
export const savedFrames = new SavedFrames(storage);

/** The frames that can be read. */
export const listed = computed(() => {
  const { value } = savedFrames.stored;
  return value.kind === 'list' ? value.items : [];
});

export const savedCount = computed(() => listed.value.length);

/** A list of frames is small; anything bigger is another file chosen by mistake. */
const LARGEST = 5_000_000;

type SavedWords = WordsOf<'saved'>;

/** What was done under a name; if that was taken, that both frames are kept. */
export const namingText = (words: SavedWords, { wanted, got }: Naming, done: (name: string) => string): string =>
  wanted === got ? done(got) : words.nameTaken(wanted, got);

/** Imports a file that a person chose. Answers the result in sentences. */
export async function importFile(file: File, words: SavedWords): Promise<readonly string[]> {
  if (file.size > LARGEST) return [words.fileTooBig(file.name)];
  const text = await file.text().catch(() => undefined);
  if (text === undefined) return [words.fileUnread(file.name)];
  const reading = readSaved(text);
  if (reading.kind === 'unreadable') return [words.badFile(file.name, reading.fault)];
  const bad = reading.bad.map(({ row, why }) => words.badRow(row, why));
  const outcome = savedFrames.import(reading.frames);
  if (typeof outcome === 'string') return [words.refusals[outcome], ...bad];
  const { added, already } = outcome;
  return [
    words.imported(added.length),
    ...(already > 0 ? [words.already(already)] : []),
    ...added.filter(({ wanted, got }) => wanted !== got).map((naming) => namingText(words, naming, String)),
    ...bad,
  ];
}

/** Opens a frame of the drawer as one step, in sight beside it. */
export function openKept(draft: Draft): void {
  step(draft);
  document.querySelector('.strip-main')?.scrollIntoView({ block: 'nearest' });
}
