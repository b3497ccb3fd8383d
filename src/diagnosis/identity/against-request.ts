import type { ProblemCode, Reading } from '../../modbus/index.ts';

/** Problems of a reply that does not answer its request. */
export const AGAINST_REQUEST: ReadonlySet<ProblemCode> = new Set<ProblemCode>([
  'unit-not-as-requested',
  'transaction-not-as-requested',
  'function-not-as-requested',
  'count-not-as-requested',
  'echo-differs',
  'broadcast-answered',
]);

/** Whether a reply that was read with its request does not answer it. */
export const isAgainstRequest = ({ problems }: Reading): boolean =>
  problems.some(({ code }) => AGAINST_REQUEST.has(code));
