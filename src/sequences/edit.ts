import type { StepPlace } from './sequence.ts';
import { type SequenceTexts, type StepTexts, withList } from './texts.ts';

type Steps = readonly StepTexts[];

/** The list that a place is in: that of the repetition around it, or the sequence's own. */
function listAt(sequence: SequenceTexts, { list, at }: StepPlace): Steps {
  let steps: Steps = sequence[list];
  for (const index of at.slice(0, -1)) steps = steps[index]?.steps ?? [];
  return steps;
}

/** The step at a place, if there is one. */
export const stepAt = (sequence: SequenceTexts, place: StepPlace): StepTexts | undefined =>
  listAt(sequence, place)[place.at.at(-1) ?? 0];

/** The sequence with a new list in place of the one that holds this place. */
function changeList(sequence: SequenceTexts, { list, at }: StepPlace, make: (steps: Steps, index: number) => Steps) {
  const change = (steps: Steps, [index = 0, ...inner]: readonly number[]): Steps =>
    inner.length === 0
      ? make(steps, index)
      : steps.map((step, each) => (each === index ? { ...step, steps: change(step.steps ?? [], inner) } : step));
  return withList(sequence, list, change(sequence[list], at));
}

/** Inserts steps in front of a place; a place after the last step is the end of the list. */
export const insertAt = (sequence: SequenceTexts, place: StepPlace, ...steps: Steps): SequenceTexts =>
  changeList(sequence, place, (list, index) => list.toSpliced(index, 0, ...steps));

export const removeAt = (sequence: SequenceTexts, place: StepPlace): SequenceTexts =>
  changeList(sequence, place, (list, index) => list.toSpliced(index, 1));

export function duplicateAt(sequence: SequenceTexts, place: StepPlace): SequenceTexts {
  const step = stepAt(sequence, place);
  return step === undefined ? sequence : insertAt(sequence, neighbour(place, 1), step);
}

/** The sequence with another text in a field of a step. */
export const withField = (sequence: SequenceTexts, place: StepPlace, field: string, text: string): SequenceTexts =>
  changeList(sequence, place, (list, at) =>
    list.map((step, index) => (index === at ? { ...step, fields: { ...step.fields, [field]: text } } : step)),
  );

/** The place this number of steps further in the same list. */
export const neighbour = ({ list, at }: StepPlace, by: number): StepPlace => ({
  list,
  at: [...at.slice(0, -1), (at.at(-1) ?? 0) + by],
});

/**
 * Where a step goes when it is moved up (−1) or down (1): into a repetition that stands there, or out of the one it is
 * first or last in. `undefined` where it is at the end of everything.
 */
export function movedTo(sequence: SequenceTexts, place: StepPlace, by: 1 | -1): StepPlace | undefined {
  const { list, at } = place;
  const beside = neighbour(place, by);
  const other = stepAt(sequence, beside);
  const index = beside.at.at(-1) ?? 0;
  const outer: StepPlace = { list, at: at.slice(0, -1) };
  if (other?.steps) {
    // When the step is removed, a repetition below it moves into its place.
    const around = by > 0 ? at : beside.at;
    return { list, at: [...around, by > 0 ? 0 : other.steps.length] };
  }
  if (other !== undefined) return beside;
  if (at.length === 1) return undefined;
  return index < 0 ? outer : neighbour(outer, 1);
}

/** Moves a step up or down by one; nothing changes if it cannot go further. */
export function moveAt(sequence: SequenceTexts, place: StepPlace, by: 1 | -1): SequenceTexts {
  const step = stepAt(sequence, place);
  const to = movedTo(sequence, place, by);
  return step === undefined || to === undefined ? sequence : insertAt(removeAt(sequence, place), to, step);
}
