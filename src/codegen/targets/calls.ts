import type { Transport, Values } from '../../modbus/index.ts';
import type { PlannedRequest } from '../plan.ts';

/** How a library or a command carries a function out. */
export interface Call {
  readonly code: number;
  /** Fields that must have these values; a function may mean several calls. */
  readonly when?: Readonly<Record<string, unknown>>;
  /** What the fields must be besides. */
  readonly fits?: (fields: Values) => boolean;
  /** By what the library can take the reply; by all that the target has, if absent. */
  readonly transports?: readonly Transport[];
  /** The call: `{startAddress}` is the field of this name as the language writes it, `{unitId}` the unit. */
  readonly text: string;
  /** What of the answer is printed. */
  readonly gives?: string;
}

/** How a language writes the value of a field. */
export type WriteValue = (value: unknown, field: string) => string;

/**
 * The call for a request; `undefined` if there is none that sends the same bytes: the function is not in the table, the frame
 * is not what an encoder makes of its fields, or breaks a rule that a library may insist on.
 */
export function callFor(calls: readonly Call[], { input, reading }: PlannedRequest): Call | undefined {
  const { outcome, forced, problems, functionCode, fields } = reading;
  const isPlain = outcome.kind === 'whole' && Object.keys(forced).length === 0 && input.direction === 'request';
  if (!isPlain || problems.some(({ severity }) => severity === 'error')) return undefined;
  return calls.find(
    ({ code, when = {}, transports, fits }) =>
      code === functionCode &&
      (fits === undefined || fits(fields)) &&
      (transports === undefined || transports.includes(input.transport)) &&
      Object.entries(when).every(([name, value]) => fields[name] === value),
  );
}

/** The call with the values of the request. */
export function callText({ text }: Call, { reading }: PlannedRequest, write: WriteValue): string {
  const values: Values = { ...reading.derived, ...reading.fields, unitId: reading.unitId };
  return text.replace(/\{(\w+)\}/g, (_, field: string) => write(values[field], field));
}

/** The numbers of a list: registers, or bits as 0 and 1. */
export const numbersOf = (value: unknown): readonly number[] => (Array.isArray(value) ? value.map(Number) : []);
