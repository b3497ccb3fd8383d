import type { Draft } from './draft.ts';
import type { Control, Evaluation } from './evaluate.ts';

/** Which fields the form of a frame has, by their paths and in their order. */
export interface FormLayout {
  /** Numbers of the frame's envelope that are typed. */
  readonly envelope: readonly string[];
  readonly fields: readonly string[];
  /** Whether the request that the frame answers is asked for. */
  readonly answering: boolean;
  /** What the encoder works out. What a link forces and the form does not offer is shown here all the same. */
  readonly derived: readonly string[];
}

/** Lays the form out, by the description of the function. */
export function formLayout({ transport, kind, force }: Draft, { controls }: Evaluation): FormLayout {
  const free = (path: string) => !Object.hasOwn(force, path);
  const derived = [
    ...(transport === 'tcp' ? ['protocolId', 'length'] : []),
    ...controls.filter((control) => control.derived).map(({ path }) => path),
    ...(transport === 'rtu' || transport === 'ascii' ? ['checksum'] : []),
  ];
  return {
    envelope: [...(transport === 'tcp' ? ['transactionId'] : []), ...(transport === 'pdu' ? [] : ['unitId'])].filter(
      free,
    ),
    fields: controls.filter((control) => !control.derived && free(control.path)).map(({ path }) => path),
    answering: kind !== 'request',
    derived: [...derived, ...Object.keys(force).filter((name) => !derived.includes(name))],
  };
}

/** Controls and those inside their groups, by path. */
export function controlsByPath(controls: readonly Control[]): ReadonlyMap<string, Control> {
  const found = new Map<string, Control>();
  const add = (control: Control): void => {
    found.set(control.path, control);
    control.groups.flat().forEach(add);
  };
  controls.forEach(add);
  return found;
}

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
