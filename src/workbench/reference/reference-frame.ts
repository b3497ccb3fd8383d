import type { Problem, Section } from '../../modbus/index.ts';
import { type Draft, firstDraft } from '../frame/draft.ts';
import { evaluate } from '../frame/evaluate.ts';

/** Parts of a draft; what they leave out is an RTU request of unit 1 with values as a new form has them. */
export type ReferenceFrame = Partial<Omit<Draft, 'texts'>> & {
  readonly texts: Readonly<Record<string, string | number>>;
};

export function referenceDraft({ texts, ...parts }: ReferenceFrame): Draft {
  const asText = Object.entries(texts).map(([name, value]) => [name, String(value)] as const);
  return { ...firstDraft, ...parts, texts: Object.fromEntries(asText) };
}

/** What is wrong or noteworthy in a frame; nothing if it has no bytes. */
export const problemsOf = (frame: ReferenceFrame): readonly Problem[] =>
  evaluate(referenceDraft(frame)).frame?.reading.problems ?? [];

/** The section about a field's value; `undefined` if there is none. */
export const sectionOfProblem = (frame: ReferenceFrame, field: string): Section | undefined =>
  problemsOf(frame).find(({ span }) => span.name === field)?.section;
