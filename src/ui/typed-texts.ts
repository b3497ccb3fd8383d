/** What was typed last where the frame gets another text made of it, by the path of its field. */
const typedTexts = new Map<string, string>();

/** Makes the text a frame's field gets of what was typed. */
type InFrame = (typed: string) => string;

/** What was typed in a field, as long as the field still has what was made of it. */
export function typedText(path: string, text: string, inFrame: InFrame): string | undefined {
  const typed = typedTexts.get(path);
  return typed !== undefined && typed !== text && inFrame(typed) === text ? typed : undefined;
}

/** Keeps what is typed in a field, and answers the text the field gets. */
export function takeTyped(path: string, typed: string, inFrame: InFrame): string {
  typedTexts.set(path, typed);
  return inFrame(typed);
}
