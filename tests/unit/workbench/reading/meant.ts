import { type Draft, evaluate, type InputMeaning, inputMeaning, readText } from '../../../../src/workbench/index.ts';
import { draftMeant } from '../../../../src/workbench/reading/draft-meant.ts';
import { inputContext } from './input-context.ts';

/** What a text is taken for beside the first frame, with no device chosen unless one is named by its id. */
export const meant = (text: string, device?: string): InputMeaning =>
  inputMeaning(readText(text, undefined), inputContext(undefined, device));

/** The bytes of a draft, in capitals; empty if it has no frame. */
export const hexOf = (draft: Draft | undefined): string =>
  Buffer.from((draft && evaluate(draft).frame?.bytes) ?? [])
    .toString('hex')
    .toUpperCase();

/** The bytes of the frame that a text is taken for; empty if it is taken for none. */
export const takenHex = (text: string, device?: string): string => hexOf(draftMeant(meant(text, device)));

/** The bytes of everything that a text may be, what it was taken for first. */
export function framesOf(text: string, device?: string): readonly string[] {
  const meaning = meant(text, device);
  if (meaning.kind === 'several') return meaning.offers.map(({ draft }) => hexOf(draft));
  if (meaning.kind !== 'address') return [];
  return [meaning.taken, ...meaning.others].map(({ draft }) => hexOf(draft));
}
