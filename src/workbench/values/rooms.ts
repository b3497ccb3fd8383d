import type { Control, Evaluation } from '../frame/evaluate.ts';

/** The field of function 06, which stands for one register. */
const isSingle = ({ field }: Control, { description: { table } }: Evaluation): boolean =>
  field.name === 'value' && field.kind === 'number' && table === 'holding-register';

/** How many registers a field takes; 0 if it does not hold registers. */
export const roomOf = (control: Control, evaluation: Evaluation): number =>
  control.field.kind === 'registers' ? Number.POSITIVE_INFINITY : isSingle(control, evaluation) ? 1 : 0;

/** The fields of the form that hold registers, those inside groups too. */
export const targetsOf = (evaluation: Evaluation, controls = evaluation.controls): readonly Control[] =>
  controls.flatMap((control) => [
    ...(roomOf(control, evaluation) > 0 && !control.derived ? [control] : []),
    ...control.groups.flatMap((group) => targetsOf(evaluation, group)),
  ]);
