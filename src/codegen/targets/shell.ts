import { rtuSilences } from '../../modbus/index.ts';
import type { Code, Expression, Name } from '../code.ts';
import type {
  BuildArgument,
  Plan,
  PlannedRequest,
  PlannedSequence,
  PlannedStep,
  ScaledValue,
  Settings,
} from '../plan.ts';

/** What programs of all languages need to know of the line, the server and what is in a plan. */

const MOST_BITS = 11;

/** The silence between two frames, in whole milliseconds, at least 2 (SL 2.5.1.1). */
export const pauseOf = ({ line }: Settings): number =>
  Math.max(2, Math.ceil(rtuSilences(line.baud, MOST_BITS).t35 / 1000));

/** The silence that ends a reply whose length no byte says, in milliseconds: more than a PC's own pauses. */
export const SILENCE = 50;

/** What devices are given after a broadcast, in milliseconds (SL 2.4.1). */
export const TURNAROUND = 100;

/** Whether an expression of this kind is anywhere in the code. */
export const uses = (code: Code, kind: Expression['kind']): boolean =>
  JSON.stringify(code.routines).includes(`"kind":"${kind}"`);

/** What of the program is written besides the code. */
export const partsOf = ({ options, sequence, transport }: Plan) => ({
  checks: sequence !== undefined || options.part === 'check' || options.part === 'exchange',
  // A bare PDU is carried by nothing.
  exchanges: transport !== 'pdu' && (sequence !== undefined || options.part === 'exchange'),
});

/** A file may not have a longer name everywhere. */
export const LONGEST_FILE_NAME = 100;

/** What the files of a plan are called, before the ending. */
export const programName = ({ requests, sequence }: Plan): string => {
  if (sequence !== undefined) return 'modbus sequence';
  return requests.length === 1 && requests[0]
    ? `modbus ${requests[0].name}`.slice(0, LONGEST_FILE_NAME).trim()
    : 'modbus requests';
};

/** What the program does, in a line. */
export const programAbout = ({ requests, sequence }: Plan): string => {
  if (sequence !== undefined) return 'A sequence of Modbus requests.';
  return requests.length === 1 && requests[0] ? requests[0].about : `${requests.length} Modbus requests.`;
};

export const isAnswered = ({ check, wanted }: { readonly check?: unknown; readonly wanted?: unknown }): boolean =>
  check !== undefined && wanted !== undefined;

/** Whether any step waits for a condition. */
export const waits = ({ steps, finally: last }: PlannedSequence): boolean => {
  const any = (list: readonly PlannedStep[]): boolean =>
    list.some((step) => step.kind === 'until' || (step.kind === 'repeat' && any(step.steps)));
  return any(steps) || any(last);
};

/** The texts of an argument's values: of those in units a call of the routine that makes the register of it. */
export const argumentTexts = (
  { value, scaled = [] }: BuildArgument,
  plain: (value: number) => string,
  call: (scaled: ScaledValue) => string,
): readonly string[] =>
  (typeof value === 'number' ? [value] : value).map((one, index) => {
    const own = scaled.find((given) => given.index === index);
    return own === undefined ? plain(one) : call(own);
  });

/**
 * The call that tells how many elements of its list a reply fills; `undefined` if it fills all. `slices`: an array knows its
 * length, so that a routine that takes both has one parameter.
 */
export function itemsCall(
  { items }: Pick<PlannedRequest, 'items'>,
  name: (routine: Name) => string,
  length: string,
  slices = false,
): string | undefined {
  if (items === undefined) return undefined;
  const taken = slices && items.takes.includes('reply') ? ['reply'] : items.takes;
  return `${name(items.routine)}(${taken.map((one) => (one === 'reply' ? one : length)).join(', ')})`;
}
