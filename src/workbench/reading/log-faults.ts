import type { ConversationItem } from '../../diagnosis/index.ts';
import { decodeFrame, type Severity } from '../../modbus/index.ts';

/** A frame of the text, or bytes in none, with what the text says of it: its time stamp, and whether it was received. */
export type PastedItem = ConversationItem & {
  readonly time: string | undefined;
  readonly said: 'request' | 'response' | undefined;
};

/** What goes wrong in a log, the gravest first. */
export const logFaultKinds = ['no-frame', 'checksum', 'error', 'exception', 'no-reply', 'warning'] as const;
export type LogFaultKind = (typeof logFaultKinds)[number];

/** What went wrong with an item: `code` is that of an exception. */
export interface LogFault {
  readonly kind: LogFaultKind;
  readonly code?: number;
}

/** The faults of a text by the index of their item, in the order of the text, and how many there are of each kind. */
export interface LogFaults {
  readonly byIndex: ReadonlyMap<number, LogFault>;
  readonly counts: ReadonlyMap<LogFaultKind, number>;
}

/** Finds what went wrong in a log, given its items and all their bytes. Takes time linear in their number. */
export function logFaults(items: readonly PastedItem[], bytes: Uint8Array): LogFaults {
  const byIndex = new Map<number, LogFault>();
  const counts = new Map<LogFaultKind, number>();
  const waits = unanswered(items, bytes);
  items.forEach((item, index) => {
    const fault = ownFault(item, bytes) ?? (waits.has(index) ? { kind: 'no-reply' as const } : undefined);
    if (fault === undefined) return;
    byIndex.set(index, fault);
    counts.set(fault.kind, (counts.get(fault.kind) ?? 0) + 1);
  });
  return { byIndex, counts };
}

/** The next item behind `from` with a fault of a kind, or else the first; −1 if there is none. */
export function nextOfKind({ byIndex }: LogFaults, kind: LogFaultKind, from: number): number {
  const all = [...byIndex].flatMap(([index, fault]) => (fault.kind === kind ? [index] : []));
  return all.find((index) => index > from) ?? all[0] ?? -1;
}

/** How bad a fault is: what is not a good frame, or what is one. */
export const faultSeverity = ({ kind }: LogFault): Severity =>
  ['no-frame', 'checksum', 'error'].includes(kind) ? 'error' : 'warning';

/** What is wrong with an item in itself. */
function ownFault(item: PastedItem, bytes: Uint8Array): LogFault | undefined {
  if (item.kind === 'unread') return { kind: 'no-frame' };
  const { severity, direction, from, to } = item;
  const isGrave = severity === 'error' || severity === 'warning';
  if (!isGrave && direction === 'request') return undefined;
  const { problems, functionCode = 0, fields } = decodeFrame(bytes.subarray(from, to), item);
  if (isGrave) {
    return { kind: problems.some(({ code }) => code === 'checksum-wrong') ? 'checksum' : severity };
  }
  const { exceptionCode } = fields;
  return functionCode > 0x7f && typeof exceptionCode === 'number'
    ? { kind: 'exception', code: exceptionCode }
    : undefined;
}

/**
 * The requests that nothing answers, of a log: it tells a time or a side, and has replies. The last one may have been
 * answered after the text ends.
 */
function unanswered(items: readonly PastedItem[], bytes: Uint8Array): ReadonlySet<number> {
  const answered = new Set(items.flatMap((item) => (item.kind === 'frame' ? [item.answers] : [])));
  const hasReplies = answered.size > (answered.has(undefined) ? 1 : 0);
  const waiting = items.flatMap((item, index) => {
    const isAsked = item.kind === 'frame' && item.direction === 'request' && (item.time ?? item.said) !== undefined;
    const waits = isAsked && index < items.length - 1 && !answered.has(index) && !isBroadcast(item, bytes);
    return waits ? [index] : [];
  });
  return new Set(hasReplies ? waiting : []);
}

/** Whether a request goes to every device, and none may answer (SL 2.1). */
const isBroadcast = (item: PastedItem & { readonly kind: 'frame' }, bytes: Uint8Array): boolean =>
  item.transport !== 'tcp' && decodeFrame(bytes.subarray(item.from, item.to), item).unitId === 0;
