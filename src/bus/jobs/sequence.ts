import { decodeFrame, sameBytes, type Value } from '../../modbus/index.ts';
import {
  holds,
  type ListName,
  listNames,
  readingRequest,
  type Sequence,
  type Step,
  type StepPlace,
  type Until,
  valueIn,
} from '../../sequences/index.ts';
import { mayChange } from '../guard.ts';
import { knownAt, type TransactionResult, type Unsure, type Verdict } from '../transaction/result.ts';
import type { TransactionRules } from '../transaction/rules.ts';
import type { JobParts, RunningJob } from './job.ts';

/** A sequence that is carried out once. */
export interface SequenceOrder {
  readonly kind: 'sequence';
  readonly sequence: Sequence;
}

/** What a step came to. */
export type StepOutcome =
  | {
      readonly kind: 'sent';
      readonly outcome: TransactionResult['outcome']['kind'];
      readonly verdict: Verdict;
      /** Why the reply may be the answer to another request. */
      readonly unsure?: Unsure;
      /** The reply or exception. */
      readonly reply?: Uint8Array;
      /** Milliseconds from the request to the reply. */
      readonly duration?: number;
    }
  | { readonly kind: 'waited' }
  /** The condition holds for this value, after this number of requests. */
  | { readonly kind: 'held'; readonly value: Value; readonly requests: number }
  /** The condition did not hold in time. The value is the one that was read last, if one was. */
  | { readonly kind: 'timed-out'; readonly value?: Value; readonly requests: number }
  | { readonly kind: 'repeated'; readonly times: number }
  /** A repetition in which a step failed. */
  | { readonly kind: 'failed' }
  | { readonly kind: 'stopped' }
  /** The line is gone. */
  | { readonly kind: 'lost' };

/** How a list has ended. */
export type SequenceEnd = 'done' | 'failed' | 'stopped' | 'lost';

export type SequenceNews =
  /** `rounds` has the round, counted from 0, of each repetition around the step. `time`: milliseconds since 1970. */
  | {
      readonly kind: 'step-began';
      readonly place: StepPlace;
      readonly rounds: readonly number[];
      readonly time: number;
    }
  | { readonly kind: 'step-ended'; readonly place: StepPlace; readonly time: number; readonly outcome: StepOutcome }
  /** Told of the steps, and then of the finally list. There, `failed` means that at least one of its steps failed. */
  | { readonly kind: 'list-ended'; readonly list: ListName; readonly how: SequenceEnd };

/**
 * Carries out a sequence: the steps, and then the finally list, however the steps ended. The first stop makes it
 * continue with the finally list, or in it, because whoever stops it may not know yet that the steps have just ended. A second
 * stop in the finally list ends it.
 */
export function startSequence(order: SequenceOrder, parts: JobParts<SequenceNews>): RunningJob {
  const run = new SequenceRun(order.sequence, parts);
  return { stop: () => run.stop(), ended: run.carryOut() };
}

/**
 * Every request of a sequence, once. Those that may change a device come first, because somebody is asked about them.
 */
export function sequenceRequests({ transport, ...lists }: Sequence): readonly Uint8Array[] {
  const all = new Map<string, Uint8Array>();
  const collect = (steps: readonly Step[]) => {
    for (const step of steps) {
      if (step.kind === 'repeat') collect(step.steps);
      else if (step.kind !== 'wait') {
        const request = step.kind === 'send' ? step.bytes : readingRequest(step, transport);
        all.set(request.join(), request);
      }
    }
  };
  for (const list of listNames) collect(lists[list]);
  const requests = [...all.values()];
  const changes = (request: Uint8Array) => mayChange(decodeFrame(request, { transport, direction: 'request' }));
  return [...requests.filter(changes), ...requests.filter((request) => !changes(request))];
}

class SequenceRun {
  readonly #sequence: Sequence;
  readonly #parts: JobParts<SequenceNews>;
  #list: ListName = 'steps';
  #asked = false;
  #stopped = false;
  #wake = () => {};

  constructor(sequence: Sequence, parts: JobParts<SequenceNews>) {
    this.#sequence = sequence;
    this.#parts = parts;
  }

  stop(): void {
    const first = !this.#asked;
    this.#asked = true;
    if (first && this.#list === 'finally') return;
    this.#stopped = true;
    this.#wake();
  }

  async carryOut(): Promise<void> {
    for (const list of listNames) {
      // Stopping the steps does not stop the finally list.
      this.#stopped = false;
      this.#list = list;
      const how = await this.#carryOut(this.#sequence[list], { list, at: [] }, []);
      this.#parts.tell({ kind: 'list-ended', list, how });
    }
  }

  async #carryOut(steps: readonly Step[], { list, at }: StepPlace, rounds: readonly number[]): Promise<SequenceEnd> {
    const { clock, tell } = this.#parts;
    let end: SequenceEnd = 'done';
    for (const [index, step] of steps.entries()) {
      if (this.#stopped) return 'stopped';
      const place = { list, at: [...at, index] };
      tell({ kind: 'step-began', place, rounds, time: clock.origin + clock.now() });
      const outcome = await this.#step(step, place, rounds);
      tell({ kind: 'step-ended', place, time: clock.origin + clock.now(), outcome });
      if (outcome.kind === 'stopped' || outcome.kind === 'lost') return outcome.kind;
      if (!isFailure(outcome)) continue;
      if (list === 'finally') end = 'failed';
      else if (step.kind === 'repeat' || step.kind === 'wait' || step.onFailure === 'stop') return 'failed';
    }
    return end;
  }

  async #step(step: Step, place: StepPlace, rounds: readonly number[]): Promise<StepOutcome> {
    switch (step.kind) {
      case 'send':
        return this.#send(step.bytes);
      case 'wait':
        await this.#pause(step.duration);
        return { kind: this.#stopped ? 'stopped' : 'waited' };
      case 'until':
        return this.#until(step);
      case 'repeat': {
        let failed = false;
        for (let round = 0; round < step.times; round++) {
          const end = await this.#carryOut(step.steps, place, [...rounds, round]);
          if (end === 'stopped' || end === 'lost') return { kind: end };
          failed ||= end === 'failed';
          if (failed && place.list === 'steps') break;
        }
        return failed ? { kind: 'failed' } : { kind: 'repeated', times: step.times };
      }
    }
  }

  async #send(request: Uint8Array): Promise<StepOutcome> {
    const began = this.#parts.clock.now();
    const result = await this.#transact(request);
    const { outcome, verdict, sentAt, endedAt } = result;
    // Cancelled and sent again, it may be answered by the reply to either.
    const unsure = isOf(result, request, began) ? undefined : result.unsure;
    if (isGone(outcome)) return { kind: this.#stopped ? 'stopped' : 'lost' };
    const end = knownAt(outcome, endedAt);
    return {
      kind: 'sent',
      outcome: outcome.kind,
      verdict,
      ...(unsure !== undefined && { unsure }),
      ...('bytes' in outcome && { reply: outcome.bytes }),
      ...(sentAt !== undefined && { duration: end - sentAt }),
    };
  }

  async #until(until: Until): Promise<StepOutcome> {
    const { clock } = this.#parts;
    const request = readingRequest(until, this.#sequence.transport);
    const start = clock.now();
    const due = start + until.timeout;
    let value: Value | undefined;
    for (let requests = 1; ; requests++) {
      const began = clock.now();
      // The next reading is the retry. No reading waits longer than the rest of the condition's time.
      const left = Math.max(1, due - began);
      const timeout = Math.min(this.#parts.client.rules.timeout, left);
      const result = await this.#transact(request, { timeout, retries: 0 });
      const { outcome, verdict } = result;
      if (isGone(outcome)) return { kind: this.#stopped ? 'stopped' : 'lost' };
      if (outcome.kind === 'reply' && verdict !== 'bad' && isOf(result, request, start)) {
        value = valueIn(outcome.reading.fields, until);
        if (value !== undefined && holds(until, value)) return { kind: 'held', value, requests };
      }
      if (this.#stopped) return { kind: 'stopped' };
      const next = Math.max(began + until.interval, clock.now());
      if (next >= due) {
        await this.#pause(due - clock.now());
        if (this.#stopped) return { kind: 'stopped' };
        return { kind: 'timed-out', requests, ...(value !== undefined && { value }) };
      }
      await this.#pause(next - clock.now());
      if (this.#stopped) return { kind: 'stopped' };
    }
  }

  /**
   * Sends a request of a list. When everything was stopped, the session has made another client for the line: a request
   * of the finally list that was cancelled with the old client is then sent again with the new one.
   */
  async #transact(request: Uint8Array, rules: Partial<TransactionRules> = {}): Promise<TransactionResult> {
    const { transport } = this.#sequence;
    for (;;) {
      const { client } = this.#parts;
      const result = await client.transact(request, { ...rules, transport }).result;
      if (result.outcome.kind !== 'cancelled' || this.#stopped || client === this.#parts.client) return result;
    }
  }

  #pause(delay: number): Promise<void> {
    if (delay <= 0 || this.#stopped) return Promise.resolve();
    return new Promise((resolve) => {
      const off = this.#parts.clock.after(delay, resolve);
      this.#wake = () => {
        off();
        resolve();
      };
    });
  }
}

/** Whether a reply is to this request, sent at this time or later: one that is late answers an earlier reading, which is as good. */
const isOf = ({ unsure, perhapsTo }: TransactionResult, request: Uint8Array, since: number): boolean =>
  unsure === undefined ||
  (perhapsTo !== undefined && sameBytes(perhapsTo.request, request) && perhapsTo.sentAt >= since);

/** Whether the list has to end: the line is gone, or everything was stopped. */
const isGone = (outcome: TransactionResult['outcome']): boolean =>
  outcome.kind === 'lost' ||
  outcome.kind === 'cancelled' ||
  (outcome.kind === 'not-sent' && outcome.why === 'not-open');

/** Whether a step has failed. */
export function isFailure(outcome: StepOutcome): boolean {
  if (outcome.kind === 'sent') {
    return outcome.unsure !== undefined || (outcome.verdict !== 'good' && outcome.verdict !== 'doubtful');
  }
  return outcome.kind === 'timed-out' || outcome.kind === 'failed';
}
