import type { Draft } from '../frame/draft.ts';
import type { InputMeaning } from './input-meaning.ts';

/** The draft that a meaning comes to; `undefined` if the frames decide, or nothing is taken. */
export function draftMeant(meaning: InputMeaning): Draft | undefined {
  switch (meaning.kind) {
    case 'address':
    case 'function':
      return meaning.taken.draft;
    case 'value-with-unit':
      return meaning.draft;
    default:
      return undefined;
  }
}
