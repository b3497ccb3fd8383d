import { batch, computed, effect, type ReadonlySignal, type Signal, signal } from '@preact/signals-core';
import type { JobNews, LinkSettings, Refusal, TrialNews, TrialOrder } from '../bus/index.ts';
import { sameBytes } from '../modbus/index.ts';
import {
  type NoAnswerStep,
  noAnswerSteps,
  planOf,
  type StepFinding,
  type StepPlan,
  scanFinding,
  stepMarks,
  trialFinding,
  type Unanswered,
} from '../workbench/index.ts';
import type { Bus } from './bus.ts';
import { Job } from './job.ts';
import type { Scan } from './scan.ts';

/** Requests that are sent to find out why one is not answered. */
class Trials extends Job {
  readonly news: Signal<readonly TrialNews[]> = signal([]);

  constructor(host: Bus) {
    super('trials', host);
  }

  start(order: TrialOrder): void {
    this.news.value = [];
    this.begin(order, order.transport);
  }

  protected take(all: readonly JobNews[]): void {
    this.news.value = [...this.news.peek(), ...all.flatMap((news) => (news.kind === 'tried' ? [news] : []))];
  }
}

interface Begun {
  readonly step: NoAnswerStep;
  readonly about: Unanswered;
  readonly plan: StepPlan;
  /** How the line was set before. */
  readonly settings: LinkSettings;
}

/** Why a request is not answered: what was tried, what was found, and what was excluded. It goes on while it is not shown. */
export class NoAnswer {
  /** The request that it is about: the last that was not answered, or else the current frame; `undefined` if that is no request. */
  readonly about: ReadonlySignal<Unanswered | undefined>;
  /** Whether that was sent, and not answered. */
  readonly wasAsked = computed(() => this.#unanswered.value !== undefined);
  /** The step that is being carried out. */
  readonly running: ReadonlySignal<NoAnswerStep | undefined>;
  readonly marks = computed(() => stepMarks(this.#findings.value, this.running.value, this.about.value));
  /** How far the scan of the step that runs is. */
  readonly progress = computed(() => (this.running.value && this.#scans() ? this.#scan.progress.value : undefined));
  /** Why the last step was not begun. */
  readonly refused: Signal<Refusal | undefined> = signal(undefined);
  /** Another scan is going on. */
  readonly busy = computed(() => this.running.value === undefined && this.#scan.running.value);
  readonly #bus: Bus;
  readonly #scan: Scan;
  readonly #trials: Trials;
  readonly #unanswered: Signal<Unanswered | undefined> = signal(undefined);
  readonly #findings: Signal<ReadonlyMap<NoAnswerStep, StepFinding>> = signal(new Map());
  /** The step that was begun last, about what, and what it does. */
  readonly #begun: Signal<Begun | undefined> = signal(undefined);

  /** @param current the current frame, if it is a request that can be sent */
  constructor(bus: Bus, scan: Scan, current: ReadonlySignal<Unanswered | undefined>) {
    this.#bus = bus;
    this.#scan = scan;
    this.#trials = new Trials(bus);
    this.about = computed(() => this.#unanswered.value ?? this.#begun.value?.about ?? current.value);
    this.running = computed(() => {
      const begun = this.#begun.value;
      const runs = this.#scans() ? scan.running.value : this.#trials.running.value;
      return begun && runs ? begun.step : undefined;
    });
    effect(() => {
      const { value: last } = bus.last;
      if (last?.outcome === 'silent') this.#take(last);
    });
    effect(() => this.#follow());
  }

  /** What a step would do now. */
  readonly plan = (step: NoAnswerStep): StepPlan => {
    const { value: about } = this.about;
    const line = { settings: this.#settings, rules: this.#bus.rules.value };
    return about ? planOf(step, about, line) : { kind: 'impossible' };
  };

  /** How the line is open, or would be. */
  get #settings(): LinkSettings {
    const { value: link } = this.#bus.link;
    return link.kind === 'open' ? link.settings : this.#bus.settings.value;
  }

  readonly start = (step: NoAnswerStep): void => {
    const about = this.about.peek();
    const plan = this.plan(step);
    if (about === undefined || this.#scan.running.peek() || this.#trials.running.peek()) return;
    if (plan.kind !== 'scan' && plan.kind !== 'trials') return;
    batch(() => {
      this.refused.value = undefined;
      this.#set(step, undefined);
      this.#begun.value = { step, about, plan, settings: this.#settings };
      if (plan.kind === 'trials') this.#trials.start(plan.order);
      else this.#scan.start(plan.order);
    });
  };

  readonly stop = (): void => {
    if (this.#scans()) this.#scan.stop();
    else this.#trials.stop();
  };

  /** Somebody has looked at what no page can look at, or takes that back. */
  readonly check = (step: NoAnswerStep): void =>
    this.#set(step, this.#findings.peek().get(step) ? undefined : { code: 'checked' });

  /** Whether what was begun last is a scan, and the one that is told of. */
  #scans(): boolean {
    const { plan } = this.#begun.value ?? {};
    return plan?.kind === 'scan' && this.#scan.order.value === plan.order;
  }

  /** Takes a request that was not answered; of another than before nothing is known yet. */
  #take({ request, transport }: Unanswered): void {
    const before = this.about.peek();
    this.#unanswered.value = { request, transport };
    if (before === undefined || !sameBytes(before.request, request)) this.#findings.value = new Map();
  }

  /** Notes what the step that was begun last finds. */
  #follow(): void {
    const { value: begun } = this.#begun;
    if (begun === undefined) return;
    const { step, about, plan, settings } = begun;
    const job = plan.kind === 'scan' ? this.#scan : this.#trials;
    const { value: end } = job.end;
    if (end?.kind === 'refused') {
      this.refused.value = end.why;
      return;
    }
    let finding: StepFinding | undefined;
    if (plan.kind === 'scan' && this.#scans()) {
      const { value: progress } = this.#scan.progress;
      finding = scanFinding(about, plan.order, this.#scan.found.value, progress, settings);
      const { done = 0, total = 0 } = progress ?? {};
      if (end && done < total) finding ??= { code: 'stopped', done, total };
    } else if (plan.kind === 'trials') finding = trialFinding(step, about, this.#trials.news.value);
    if (finding) this.#set(step, finding);
    // The speed is found: the others need not be tried.
    const isLineFound = finding?.code === 'line-answers' || finding?.code === 'other-line-answers';
    if (isLineFound && this.#scan.running.value) this.#scan.stop();
  }

  #set(step: NoAnswerStep, finding: StepFinding | undefined): void {
    const findings = new Map(this.#findings.peek());
    if (finding) findings.set(step, finding);
    else findings.delete(step);
    this.#findings.value = new Map(
      noAnswerSteps.flatMap((each) => {
        const found = findings.get(each);
        return found ? [[each, found] as const] : [];
      }),
    );
  }
}
