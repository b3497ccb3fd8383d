import type { SerialMode } from '../../modbus/index.ts';
import { itemsOf, type PlannedRead, type PlanRules, planReads, requestFor, type Wanted } from '../plan.ts';
import { knownAt, type TransactionResult, type Unsure, type Verdict } from '../transaction/result.ts';
import type { JobParts, RunningJob } from './job.ts';

/** Values that are read once, in as few requests as the rules allow. */
export interface ReadOrder {
  readonly kind: 'read';
  readonly transport: SerialMode;
  readonly wanted: readonly Wanted[];
  readonly rules: PlanRules;
}

/** What one request came to. */
export interface ReadNews {
  readonly kind: 'read';
  /** The values that it has settled, by their place in the order; none if they are asked for again in other requests. */
  readonly values: readonly { readonly index: number; readonly items?: readonly number[] }[];
  /** When the reply had come or the request was given up: milliseconds since 1970. */
  readonly time: number;
  readonly outcome: TransactionResult['outcome']['kind'];
  readonly verdict: Verdict;
  readonly exceptionCode?: number;
  readonly unsure?: Unsure;
  /** Requests that are still to be sent. */
  readonly left: number;
}

/** A request, and the values that it reads. */
interface Block {
  readonly read: PlannedRead;
  readonly members: readonly { readonly index: number; readonly at: number; readonly size: number }[];
  /** It was asked before, and the reply was doubtful. */
  readonly again?: true;
}

/** ILLEGAL DATA ADDRESS and ILLEGAL DATA VALUE (AP 7): one of many registers is not there, or these are too many for the device. */
const PERHAPS_SMALLER = new Set([2, 3]);
/** A device that has answered none of so many requests is not asked the others. */
const MOST_SILENT = 3;

const blocksOf = (
  { wanted }: Pick<ReadOrder, 'wanted'>,
  indices: readonly number[],
  rules: PlanRules,
): readonly Block[] => {
  const plan = planReads(
    indices.map((index) => wanted[index] as Wanted),
    rules,
  );
  const members = plan.reads.map((): Block['members'][number][] => []);
  for (const [place, index] of indices.entries()) {
    const where = plan.places[place];
    if (where) members[where.read]?.push({ index, at: where.at, size: where.size });
  }
  return plan.reads.map((read, at) => ({ read, members: members[at] ?? [] }));
};

const planned = (order: ReadOrder) => blocksOf(order, [...order.wanted.keys()], order.rules);

/** The requests that a reading begins with. Those that come of a refused one are of the same functions, and read less. */
export const readRequests = (order: ReadOrder): readonly Uint8Array[] =>
  planned(order).map(({ read }) => requestFor(read, order.transport));

/** The requests in place of a refused one: without what nobody wants, or else its halves. None for a value alone. */
function partsOf(order: ReadOrder, { members }: Block): readonly Block[] {
  const rules = { ...order.rules, gap: 0 };
  const inOrder = members.toSorted((one, other) => one.at - other.at);
  const parts = (some: Block['members']) =>
    blocksOf(
      order,
      some.map(({ index }) => index),
      rules,
    );
  const starts = [...new Set(inOrder.map(({ at }) => at))];
  const middle = starts[Math.ceil(starts.length / 2)];
  if (middle === undefined || starts.length < 2) return [];
  const whole = parts(inOrder);
  if (whole.length > 1) return whole;
  return [...parts(inOrder.filter(({ at }) => at < middle)), ...parts(inOrder.filter(({ at }) => at >= middle))];
}

/**
 * Reads values once. A request for several that the device refuses by exception 02 or 03 is asked again in parts, so that one
 * missing register does not hide the others; one whose reply may be that to another request is asked a second time.
 */
export function startReading(
  order: ReadOrder,
  { client, clock, tell }: Pick<JobParts<ReadNews>, 'client' | 'clock' | 'tell'>,
): RunningJob {
  const { transport } = order;
  let stopped = false;
  const work = async () => {
    const queue = [...planned(order)];
    let silent = 0;
    for (let block = queue.shift(); block !== undefined && !stopped; block = queue.shift()) {
      const request = requestFor(block.read, transport);
      const result = await client.transact(request, { transport }).result;
      const { outcome, verdict, unsure, endedAt } = result;
      if (outcome.kind === 'lost' || outcome.kind === 'cancelled') return;
      if (outcome.kind === 'not-sent' && outcome.why === 'not-open') return;
      const isRefused = outcome.kind === 'exception' && unsure === undefined;
      const parts = isRefused && PERHAPS_SMALLER.has(outcome.exceptionCode) ? partsOf(order, block) : [];
      const again: readonly Block[] = unsure !== undefined && !block.again ? [{ ...block, again: true }] : [];
      queue.unshift(...parts, ...again);
      silent = outcome.kind === 'silent' ? silent + 1 : Number.NEGATIVE_INFINITY;
      const isSettled = parts.length + again.length === 0;
      const list =
        outcome.kind === 'reply' && unsure === undefined
          ? itemsOf(block.read, request, outcome.bytes, transport)
          : undefined;
      tell({
        kind: 'read',
        values: isSettled
          ? block.members.map(({ index, at, size }) => ({ index, ...(list && { items: list.slice(at, at + size) }) }))
          : [],
        time: clock.origin + knownAt(outcome, endedAt),
        outcome: outcome.kind,
        verdict,
        ...(outcome.kind === 'exception' && { exceptionCode: outcome.exceptionCode }),
        ...(unsure !== undefined && { unsure }),
        left: queue.length,
      });
      if (silent >= MOST_SILENT) return;
    }
  };
  return {
    stop() {
      stopped = true;
    },
    ended: work(),
  };
}
