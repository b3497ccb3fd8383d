import type { Clock } from '../clock.ts';
import type { LinkSettings } from '../link/link.ts';
import { lineTimes, type TransactionRules } from '../transaction/rules.ts';
import { blockRequest, blocksOf, type ScanOrder, scanRequests } from './order.ts';

/** What a scan costs on a line. */
export interface ScanEstimate {
  readonly requests: number;
  /** Milliseconds: for addresses, if all answer at once; else, if nothing answers. */
  readonly time: number;
}

/** Milliseconds that an unknown device takes to answer. */
const ANSWERING = 10;
/** Characters of a reply around its data, and of a request. */
const AROUND = 5;

/** How many requests a scan sends, and how long it takes; `current` is how the line is open. */
export function estimateScan(order: ScanOrder, current: LinkSettings, rules: TransactionRules): ScanEstimate {
  if (order.what === 'addresses') return addressEstimate(order, current, rules);
  const each = scanRequests(order);
  const lines = order.what === 'units' && order.lines.length > 0 ? order.lines : [current];
  const time = lines.reduce((sum, line) => sum + each.length * silentTime(order, line, rules), 0);
  return { requests: each.length * lines.length, time };
}

/** Milliseconds that a request without an answer takes. */
export function silentTime(order: ScanOrder, line: LinkSettings, rules: TransactionRules): number {
  const { transport, timeout } = order;
  const times = lineTimes(line, { ...rules, transport });
  return times.characters(transport === 'ascii' ? 17 : 8) + timeout + times.gap;
}

function addressEstimate(
  order: Extract<ScanOrder, { what: 'addresses' }>,
  current: LinkSettings,
  rules: TransactionRules,
): ScanEstimate {
  const { transport, table } = order;
  const times = lineTimes(current, { ...rules, transport });
  const bits = table === 'coil' || table === 'discrete-input';
  const blocks = blocksOf(order);
  const time = blocks.reduce((sum, block) => {
    const data = bits ? Math.ceil(block.quantity / 8) : 2 * block.quantity;
    const reply = transport === 'ascii' ? 2 * (AROUND + data) + 1 : AROUND + data;
    const characters = blockRequest(order, block).length + reply;
    return sum + times.characters(characters) + 2 * times.gap + ANSWERING;
  }, 0);
  return { requests: blocks.length, time };
}

/** How far a scan has come, against what was expected of it. */
export class ScanProgress {
  done = 0;
  readonly total: number;
  readonly #clock: Clock;
  readonly #began: number;
  readonly #expected: number;
  #spent = 0;

  /** @param expected milliseconds that all of it may take */
  constructor(clock: Clock, total: number, expected: number) {
    this.#clock = clock;
    this.#began = clock.now();
    this.total = total;
    this.#expected = expected;
  }

  /** @param expected milliseconds that this part of it was to take */
  settle(count: number, expected: number): void {
    this.done += count;
    this.#spent += expected;
  }

  /** Milliseconds left, at the speed so far. */
  get left(): number {
    const ahead = Math.max(0, this.#expected - this.#spent);
    return this.#spent > 0 ? (ahead * (this.#clock.now() - this.#began)) / this.#spent : ahead;
  }
}
