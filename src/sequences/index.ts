export { builtInSequences } from './built-in.ts';
export { holds, readingRequest, valueIn } from './condition.ts';
export { duplicateAt, insertAt, moveAt, movedTo, neighbour, removeAt, stepAt, withField } from './edit.ts';
export {
  readSequences,
  type SequenceEntry,
  type SequenceFileFault,
  type SequencesReading,
  type ShapeFault,
  writeSequences,
} from './file.ts';
export { type PlacedFault, readSequence, type SequenceReading, type StepFault } from './read.ts';
export {
  type ListName,
  listNames,
  onFailures,
  placeKey,
  relations,
  type Sequence,
  type Step,
  type StepKind,
  type StepPlace,
  type Until,
} from './sequence.ts';
export { newSequence, newStep, type SequenceTexts, type StepTexts, stepFields, stepKinds } from './texts.ts';
