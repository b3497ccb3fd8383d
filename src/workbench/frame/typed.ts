import { type Draft, withText } from './draft.ts';

/** The draft with what was typed in a field, where the field gets `text` made of it; `device` is the id of the device that gave it its meaning. */
export function withTyped(draft: Draft, path: string, typed: string, text: string, device?: string): Draft {
  const next = withText(draft, path, text);
  return typed === text ? next : { ...next, typed: { ...next.typed, [path]: { typed, text } }, device };
}

/** What was typed in a field, while the field still has the text that was made of it. */
export function typedAt({ typed, texts }: Draft, path: string): string | undefined {
  const entry = typed?.[path];
  return entry?.text === texts[path] ? entry?.typed : undefined;
}

/** What a field shows. */
export interface Shown {
  readonly text: string;
  /** What was typed and does not make the field's text here: its device, unit or manual is another one. */
  readonly notHere: string | undefined;
}

/** What a field shows: what was typed, if `inFrame` makes the field's text of it here too, or else that text. */
export function shownAt(draft: Draft, path: string, text: string, inFrame: (typed: string) => string): Shown {
  const typed = typedAt(draft, path);
  if (typed === undefined) return { text, notHere: undefined };
  return inFrame(typed) === text ? { text: typed, notHere: undefined } : { text, notHere: typed };
}
