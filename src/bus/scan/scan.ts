import { sameBytes } from '../../modbus/index.ts';
import type { JobParts, RunningJob } from '../jobs/job.ts';
import { isSameLine, type LinkSettings } from '../link/link.ts';
import { searchAddresses } from './address-search.ts';
import { estimateScan, ScanProgress, silentTime } from './estimate.ts';
import {
  type AddressScan,
  blockRequest,
  type FunctionScan,
  functionProbes,
  type Probe,
  type ScanOrder,
  type UnitScan,
  unitProbes,
} from './order.ts';
import { answerOf, lateAnswer, type ScanAnswer, type ScanFinding, type ScanNews } from './scan-news.ts';

type Parts = JobParts<ScanNews>;

/** How often it is asked again if a reply may be the answer to another request. */
const AGAIN = 2;

/** A reply that came after the next request was sent. */
interface Late {
  readonly request: Uint8Array;
  readonly reply: Uint8Array;
}

/** Looks for units, functions or addresses. At the end, the line has the speed and format that it had before. */
export function startScan(order: ScanOrder, parts: Parts): RunningJob {
  const scan = new Scan(parts, order);
  return { stop: () => scan.stop(), ended: scan.run() };
}

class Scan {
  readonly #parts: Parts;
  readonly #order: ScanOrder;
  readonly #before: LinkSettings | undefined;
  #over = false;

  constructor(parts: Parts, order: ScanOrder) {
    this.#parts = parts;
    this.#order = order;
    const { state } = parts.link;
    this.#before = state.kind === 'open' ? state.settings : undefined;
  }

  stop(): void {
    this.#over = true;
  }

  async run(): Promise<void> {
    const current = this.#before;
    if (current === undefined) return;
    switch (this.#order.what) {
      case 'units':
        return this.#units(this.#order, current);
      case 'functions':
        return this.#functions(this.#order, current);
      case 'addresses':
        return this.#addresses(this.#order, current);
    }
  }

  async #units(order: UnitScan, before: LinkSettings): Promise<void> {
    const probes = unitProbes(order);
    const lines = order.lines.length > 0 ? order.lines : [before];
    const progress = this.#progress(probes.length * lines.length, before);
    let now = before;
    for (const settings of lines) {
      if (this.#over) break;
      const cost = silentTime(order, settings, this.#parts.client.rules);
      if (!isSameLine(settings, now)) {
        now = settings;
        if (!(await this.#parts.reopen(settings))) {
          const { kind } = this.#parts.link.state;
          if (kind !== 'failed') break;
          progress.settle(probes.length, cost * probes.length);
          this.#tell(progress, { what: 'not-opened', settings });
          continue;
        }
      }
      await this.#probe(probes, progress, cost, ({ unit }, answer) =>
        answer.outcome === 'silent' ? undefined : { what: 'unit', unit, settings, ...answer },
      );
    }
    if (!isSameLine(now, before)) await this.#parts.reopen(before);
  }

  async #functions(order: FunctionScan, current: LinkSettings): Promise<void> {
    const probes = functionProbes(order);
    const cost = silentTime(order, current, this.#parts.client.rules);
    await this.#probe(probes, this.#progress(probes.length, current), cost, ({ functionCode }, answer) => ({
      what: 'function',
      functionCode,
      ...answer,
    }));
  }

  async #addresses(order: AddressScan, current: LinkSettings): Promise<void> {
    const { first, last } = order;
    const total = last - first + 1;
    const progress = this.#progress(total, current);
    const each = estimateScan(order, current, this.#parts.client.rules).time / total;
    await searchAddresses({
      ...order,
      ask: async (block) => (await this.#ask(blockRequest(order, block)))?.answer,
      tell: ({ address, quantity }, answer) => {
        progress.settle(quantity, quantity * each);
        this.#tell(progress, { what: 'addresses', first: address, last: address + quantity - 1, ...answer });
      },
    });
  }

  /** Sends each request and tells its answer, even if the answer comes late. */
  async #probe(
    probes: readonly Probe[],
    progress: ScanProgress,
    cost: number,
    finding: (probe: Probe, answer: ScanAnswer) => ScanFinding | undefined,
  ): Promise<void> {
    for (const probe of probes) {
      const asked = await this.#ask(probe.request);
      if (asked === undefined) return;
      for (const { request, reply } of asked.late) {
        const earlier = probes.find((one) => sameBytes(one.request, request));
        const found = earlier && finding(earlier, lateAnswer(request, reply, this.#order.transport));
        if (found) this.#tell(progress, found);
      }
      progress.settle(1, cost);
      this.#tell(progress, finding(probe, asked.answer));
    }
  }

  /** Sends a request; `undefined` if the scan has to end. */
  async #ask(
    request: Uint8Array,
  ): Promise<{ readonly answer: ScanAnswer; readonly late: readonly Late[] } | undefined> {
    if (this.#over) return undefined;
    const { transport, timeout } = this.#order;
    const ask = () => this.#parts.client.transact(request, { transport, timeout, retries: 0 }, true).result;
    let result = await ask();
    for (let again = 0; again < AGAIN && result.unsure !== undefined && !this.#over; again++) result = await ask();
    const answer = answerOf(result);
    if (answer === undefined) {
      this.#over = true;
      return undefined;
    }
    const late = result.strays.flatMap(({ what, bytes, answers }) =>
      what === 'late' && answers !== undefined ? [{ request: answers, reply: bytes }] : [],
    );
    return { answer, late };
  }

  #progress(total: number, current: LinkSettings): ScanProgress {
    const { clock, client } = this.#parts;
    const progress = new ScanProgress(clock, total, estimateScan(this.#order, current, client.rules).time);
    this.#tell(progress, undefined);
    return progress;
  }

  #tell({ done, total, left }: ScanProgress, found: ScanFinding | undefined): void {
    this.#parts.tell({ kind: 'scanned', done, total, left, ...(found && { found }) });
  }
}
