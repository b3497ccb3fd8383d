import type { ProblemCode } from './problem.ts';
import type { Reading } from './reading.ts';
import type { Span } from './span.ts';

/** Addresses of single devices on a serial line (SL 2.2). */
export const FIRST_UNIT = 1;
export const LAST_UNIT = 247;
export const BROADCAST = 0;
/** The unit identifier for a TCP server that is reached directly (TG 4.4.1.2). */
export const TCP_DIRECT = 0xff;

/** Reports what is noteworthy about the unit identifier of this frame: reserved addresses, and broadcasts. */
export function checkUnit(reading: Reading, span: Span): void {
  const unit = reading.unitId as number;
  if (unit !== BROADCAST && unit <= LAST_UNIT) return;
  if (reading.transport === 'tcp') checkTcpUnit(reading, unit, span);
  else checkSerialUnit(reading, unit, span);
}

function checkTcpUnit(reading: Reading, got: number, span: Span): void {
  if (got === BROADCAST) reading.report({ code: 'unit-zero-on-tcp', severity: 'note', section: 'TG 4.4.1.2' }, span);
  else if (got !== TCP_DIRECT) {
    reading.report({ code: 'unit-unspecified', severity: 'note', got, section: 'TG 4.4.1.2' }, span);
  }
}

function checkSerialUnit(reading: Reading, got: number, span: Span): void {
  if (got !== BROADCAST) {
    reading.report({ code: 'unit-reserved', severity: 'warning', got, section: 'SL 2.2' }, span);
  } else if (reading.direction === 'response') {
    reading.report({ code: 'reply-from-broadcast', severity: 'warning', section: 'SL 2.1' }, span);
  } else if (reading.functionCode !== undefined && !reading.description?.broadcast) {
    const { functionCode } = reading;
    reading.report({ code: 'broadcast-not-agreed', severity: 'warning', functionCode, section: 'SL 2.1' }, span);
  }
}

/** Reports where a reply's unit, transaction or function differs from the request that it answers. */
export function checkAgainstRequest(reading: Reading, request: Reading): void {
  const { spans } = reading;
  const pairs = [
    ['unitId', 'unit-not-as-requested', 'SL 2.2', reading.unitId, request.unitId],
    ['transactionId', 'transaction-not-as-requested', 'TG 3.1.3', reading.transactionId, request.transactionId],
    ['functionCode', 'function-not-as-requested', 'AP 4.1', withoutException(reading), withoutException(request)],
  ] as const;
  for (const [name, code, section, got, expected] of pairs) {
    const span = spans.find((candidate) => candidate.name === name);
    if (span === undefined || got === undefined || expected === undefined || got === expected) continue;
    reading.report({ code, severity: 'error', got, expected, section }, span);
  }
  const unit = spans.find(({ name }) => name === 'unitId');
  if (unit && request.unitId === BROADCAST && reading.transport !== 'tcp') {
    reading.report({ code: 'broadcast-answered', severity: 'error', section: 'SL 2.1' }, unit);
  }
}

const withoutException = ({ functionCode }: Reading) => functionCode && functionCode & 0x7f;

/** Problems of a reply that does not answer its request. */
export const againstRequest: ReadonlySet<ProblemCode> = new Set<ProblemCode>([
  'unit-not-as-requested',
  'transaction-not-as-requested',
  'function-not-as-requested',
  'count-not-as-requested',
  'echo-differs',
  'broadcast-answered',
]);

/** Whether a reply of RTU that was read with its request has another count, but is as long as the request makes it. */
export function isAsLongAsAsked({ transport, problems }: Reading, length: number): boolean {
  const count = problems.find(({ code }) => code === 'count-not-as-requested');
  if (transport !== 'rtu' || count?.code !== 'count-not-as-requested') return false;
  return count.span.to + count.expected + CRC_BYTES === length;
}

const CRC_BYTES = 2;

/** Whether a reply that was read with its request does not answer it. */
export const isAgainstRequest = ({ problems }: Reading): boolean =>
  problems.some(({ code }) => againstRequest.has(code));
