import type { Name } from '../../code.ts';
import type { PlannedRequest, PlannedSequence, PlannedStep } from '../../plan.ts';
import { duration, type Exchanges } from './block.ts';
import { label, message } from './request-block.ts';
import type { Section, Units, Variable } from './units.ts';

/** Stages that all steps share; those of the steps follow. */
const IDLE = 0;
const SENDING = 1;
const RECEIVING = 2;
const APART = 3;
const PAUSE = 4;
const FIRST = 10;
const STEP = 10;
/** The result of a condition that did not hold in time; far from what a check gives. */
const CONDITION_FAULT = -100;
const FAULT_CONDITION: Name = 'fault condition';

/** Writes the function block that carries out a sequence. */
export function sequenceBlock(
  units: Units,
  exchanges: Exchanges,
  sequence: PlannedSequence,
  requests: readonly PlannedRequest[],
  named: Name,
): void {
  new SequenceBlock(units, exchanges, sequence, requests, named).write();
}

interface Stage {
  readonly number: number;
  readonly about: string;
  /** `next` is the stage that follows. */
  readonly write: (next: number) => void;
}

class SequenceBlock {
  readonly #units: Units;
  readonly #exchanges: Exchanges;
  readonly #sequence: PlannedSequence;
  readonly #named: Name;
  readonly #stages: Stage[] = [];
  readonly #counters: Name[] = [];
  readonly #lists: readonly Variable[];
  readonly #answered: readonly PlannedRequest[];
  readonly #arrays = new Map<Name, Variable>();
  #next = FIRST;
  /** Where the finally list begins, known when the steps have their stages. */
  #finally = 0;
  #number = 0;
  #inFinally = false;
  #waits = false;
  #conditions = false;

  constructor(
    units: Units,
    exchanges: Exchanges,
    sequence: PlannedSequence,
    requests: readonly PlannedRequest[],
    named: Name,
  ) {
    this.#units = units;
    this.#exchanges = exchanges;
    this.#sequence = sequence;
    this.#named = named;
    this.#answered = requests.filter(({ check }) => check !== undefined);
    const lists = new Map<string, Variable>();
    for (const { list } of requests)
      if (list) lists.set(units.typeOf(list), { name: this.#listName(list), type: units.typeOf(list) });
    this.#lists = [...lists.values()];
  }

  #listName(list: NonNullable<PlannedRequest['list']>): Name {
    return `${list.type} list ${list.size ?? 0}`;
  }

  #v(name: Name): string {
    return this.#exchanges.v(name);
  }

  #set(name: Name, value: string): void {
    this.#units.lines.add(`${this.#v(name)} := ${value};`);
  }

  write(): void {
    const units = this.#units;
    const { dialect } = units;
    const end = this.#plan();
    const answered = this.#answered.length > 0;
    const many = this.#answered.length > 1;
    units.about([
      'Carries out the sequence, one stage after another. Call it in every cycle.',
      'Whatever happens, what stands under "Finally" is carried out at last.',
    ]);
    const { types, timer, time } = dialect;
    const integer = (...names: readonly Name[]) => names.map((name): Variable => ({ name, type: types.int }));
    const truth = (...names: readonly Name[]) => names.map((name): Variable => ({ name, type: types.bool }));
    const sections: readonly Section[] = this.#exchanges.sections({
      inputs: [{ name: 'stop', type: types.bool, comment: 'TRUE ends the steps, so that "Finally" comes next' }],
      outputs: [
        { name: 'result', type: types.int, comment: 'of the first step that failed; 0: none did' },
        { name: 'step number', type: types.int, comment: 'the step that is carried out' },
        { name: 'message', type: dialect.string, comment: 'the result in words' },
        { name: 'failed step', type: types.int, comment: 'the first step that failed' },
      ],
      variables: [
        ...integer('answer', 'after'),
        ...(many ? integer('request number') : []),
        ...truth('finishing'),
        ...(answered ? [{ name: 'gap timer', type: timer }] : []),
        ...(this.#waits
          ? [
              { name: 'pause timer', type: timer },
              { name: 'pause time', type: time },
            ]
          : []),
        ...(this.#conditions
          ? [...truth('in condition'), { name: 'condition timer', type: timer }, { name: 'condition time', type: time }]
          : []),
        ...integer(...this.#counters),
        ...this.#lists,
        ...this.#arrays.values(),
      ],
      constants: [
        ...(this.#conditions
          ? [
              {
                name: FAULT_CONDITION,
                role: 'constant',
                type: types.int,
                value: String(CONDITION_FAULT),
                comment: 'a condition did not hold in time',
              } as const,
            ]
          : []),
      ],
      requests: this.#answered,
    });
    units.unit('FUNCTION_BLOCK', this.#named, undefined, sections, [], () => this.#body(end));
  }

  #body(end: number): void {
    const { lines } = this.#units;
    const answered = this.#answered.length > 0;
    if (answered) this.#exchanges.timers(RECEIVING, this.#answered);
    const timer = (name: Name, runs: string, time: string) =>
      lines.add(`${this.#v(name)}(IN := ${runs}, PT := ${time});`);
    if (answered) timer('gap timer', `(${this.#v('stage')} = ${APART})`, duration(this.#exchanges.gap));
    if (this.#waits) timer('pause timer', `(${this.#v('stage')} = ${PAUSE})`, this.#v('pause time'));
    if (this.#conditions) timer('condition timer', this.#v('in condition'), this.#v('condition time'));
    this.#set('tx start', 'FALSE');
    lines.add('');
    lines.add(`CASE ${this.#v('stage')} OF`).inside(() => {
      this.#shared();
      for (const [index, { number, about, write }] of this.#stages.entries())
        lines.add(label(this.#units, number, about)).inside(() => write(this.#stages[index + 1]?.number ?? end));
      lines.add(label(this.#units, end, 'the end')).inside(() => {
        this.#set('busy', 'FALSE');
        this.#set('done', `(${this.#v('result')} = 0)`);
        this.#set('error', `(${this.#v('result')} <> 0)`);
        const late = this.#units.dialect.used(FAULT_CONDITION, 'constant');
        message(this.#units, this.#exchanges, this.#conditions ? [[late, 'a condition did not hold in time']] : []);
        this.#set('stage', String(IDLE));
      });
    });
    lines.add('END_CASE;');
    lines.add('');
    this.#set('was execute', this.#v('execute'));
  }

  #stage(about: string, write: (next: number) => void): void {
    this.#stages.push({ number: this.#next++, about, write });
  }

  /** Gives each step its stages; the number of the last stage. */
  #plan(): number {
    this.#steps(this.#sequence.steps);
    this.#align();
    this.#finally = this.#next;
    this.#stage('Finally', (next) => {
      this.#set('finishing', 'TRUE');
      if (this.#conditions) this.#set('in condition', 'FALSE');
      this.#set('stage', String(next));
    });
    this.#inFinally = true;
    this.#steps(this.#sequence.finally);
    this.#align();
    return this.#next;
  }

  /** Each step begins with a number that ends with 0, so that there is room between steps for those who change them. */
  #align(): void {
    this.#next = Math.ceil(this.#next / STEP) * STEP;
  }

  #steps(steps: readonly PlannedStep[]): void {
    for (const step of steps) this.#step(step);
  }

  #step(step: PlannedStep): void {
    const number = step.kind === 'repeat' ? this.#number : ++this.#number;
    this.#align();
    switch (step.kind) {
      case 'send': {
        this.#keep(step.request);
        this.#stage(step.about, (next) => {
          this.#set('step number', String(number));
          this.#send(step.request, next);
        });
        const stops = step.stops && !this.#inFinally;
        this.#stage('its end', (next) => this.#judge(stops, next));
        return;
      }
      case 'wait':
        this.#waits = true;
        this.#stage(step.about, (next) => {
          this.#set('step number', String(number));
          this.#pause(step.duration, next);
        });
        return;
      case 'until':
        this.#until(step, number);
        return;
      case 'repeat': {
        if (step.times === 0 || step.steps.length === 0) return;
        const counter = `round ${this.#counters.length + 1}`;
        this.#counters.push(counter);
        this.#stage(step.about, (next) => {
          this.#set(counter, '0');
          this.#set('stage', String(next));
        });
        const begin = this.#stages.length;
        this.#steps(step.steps);
        this.#stage('again?', (next) => {
          const { lines } = this.#units;
          this.#set(counter, `${this.#v(counter)} + 1`);
          lines.add(`IF ${this.#v(counter)} < ${step.times} THEN`);
          lines.inside(() => this.#set('stage', String(this.#stages[begin]?.number)));
          lines.add('ELSE');
          lines.inside(() => this.#set('stage', String(next)));
          lines.add('END_IF;');
        });
      }
    }
  }

  #pause(time: number, after: number): void {
    this.#set('pause time', duration(time));
    this.#set('after', String(after));
    this.#set('stage', String(PAUSE));
  }

  #send(request: PlannedRequest, after: number): void {
    if (!this.#units.dialect.arrayValues) this.#fill(request);
    this.#exchanges.send(request, (name) => this.#given(request, name));
    if (request.check === undefined) {
      this.#set('tx start', 'TRUE');
      this.#set('answer', '0');
      this.#pause(this.#exchanges.broadcastTime([request]), after);
      return;
    }
    if (this.#answered.length > 1) this.#set('request number', String(this.#answered.indexOf(request) + 1));
    this.#set('after', String(after));
    this.#set('stage', String(SENDING));
  }

  /** What a parameter of the request is in this sequence; a list is a variable. */
  #given(request: PlannedRequest, of: Name): string {
    const found = request.arguments.find(({ parameter }) => parameter.name === of);
    if (found === undefined) throw new TypeError(`${of} is no parameter`);
    const { parameter, value } = found;
    if (typeof value === 'number') return this.#units.value(parameter.type, value);
    return this.#v(this.#arrayOf(request, parameter.name));
  }

  #arrayOf(request: PlannedRequest, of: Name): Name {
    return `${request.name} ${of}`;
  }

  /** Sets the elements of lists that have no first values. */
  #fill(request: PlannedRequest): void {
    for (const { parameter, value } of request.arguments) {
      if (typeof value === 'number') continue;
      const array = this.#v(this.#arrayOf(request, parameter.name));
      for (const [index, one] of value.entries())
        this.#units.lines.add(`${array}[${index}] := ${this.#units.value(parameter.type, one)};`);
    }
  }

  /** The lists that a request sends are variables. */
  #keep(request: PlannedRequest): void {
    if (request.check === undefined) this.#waits = true;
    for (const { parameter, value } of request.arguments) {
      if (typeof value === 'number') continue;
      const name = this.#arrayOf(request, parameter.name);
      const texts = value.map((one) => this.#units.value(parameter.type, one));
      this.#arrays.set(name, { name, type: this.#units.typeOf(parameter), value: `[${texts.join(', ')}]` });
    }
  }

  /** A failure is kept, the first one as the result; it ends the steps, or nothing. */
  #judge(stops: boolean, next: number): void {
    const { lines } = this.#units;
    const [result, answer] = [this.#v('result'), this.#v('answer')];
    if (!stops) {
      lines.add(`IF (${answer} <> 0) AND (${result} = 0) THEN`);
      lines.inside(() => this.#fail());
      lines.add('END_IF;');
      this.#set('stage', String(next));
      return;
    }
    lines.add(`IF ${answer} = 0 THEN`);
    lines.inside(() => this.#set('stage', String(next)));
    lines.add('ELSE');
    lines.inside(() => {
      lines.add(`IF ${result} = 0 THEN`);
      lines.inside(() => this.#fail());
      lines.add('END_IF;');
      this.#set('stage', String(this.#finally));
    });
    lines.add('END_IF;');
  }

  #fail(): void {
    this.#set('result', this.#v('answer'));
    this.#set('failed step', this.#v('step number'));
  }

  #until(step: Extract<PlannedStep, { kind: 'until' }>, number: number): void {
    this.#waits = true;
    this.#conditions = true;
    const { lines } = this.#units;
    this.#stage(step.about, (next) => {
      this.#set('step number', String(number));
      this.#set('condition time', duration(step.timeout));
      this.#set('in condition', 'TRUE');
      this.#set('stage', String(next));
    });
    const reading = this.#next;
    this.#stage('reads', (next) => this.#send(step.request, next));
    this.#stage('does it hold?', (next) => {
      lines.add(`IF ${this.#v('answer')} = 0 THEN`);
      lines.inside(() => {
        const [reply] = this.#units.parametersOf(step.holds);
        lines.add(`IF ${this.#units.call(step.holds, [reply?.name ?? '', this.#exchanges.reply])} THEN`);
        lines.inside(() => {
          this.#set('in condition', 'FALSE');
          this.#set('answer', '0');
        });
        lines.add('ELSE');
        lines.inside(() => this.#set('answer', this.#units.dialect.used(FAULT_CONDITION, 'constant')));
        lines.add('END_IF;');
      });
      lines.add('END_IF;');
      lines.add(`IF NOT ${this.#v('in condition')} THEN`);
      lines.inside(() => this.#set('stage', String(next)));
      lines.add(`ELSIF ${this.#v('condition timer')}.Q THEN`);
      lines.inside(() => {
        this.#set('answer', this.#units.dialect.used(FAULT_CONDITION, 'constant'));
        this.#set('in condition', 'FALSE');
        this.#set('stage', String(next));
      });
      lines.add('ELSE');
      lines.inside(() => this.#pause(step.interval, reading));
      lines.add('END_IF;');
    });
    const stops = step.stops && !this.#inFinally;
    this.#stage('its end', (next) => this.#judge(stops, next));
  }

  #shared(): void {
    const { lines } = this.#units;
    const stage = (number: number, about: string, write: () => void) =>
      lines.add(label(this.#units, number, about)).inside(write);
    stage(IDLE, 'waits for the edge', () => {
      lines.add(`IF ${this.#v('execute')} AND NOT ${this.#v('was execute')} THEN`);
      lines.inside(() => {
        this.#set('busy', 'TRUE');
        this.#set('done', 'FALSE');
        this.#set('error', 'FALSE');
        this.#set('result', '0');
        this.#set('failed step', '0');
        this.#set('finishing', 'FALSE');
        this.#set('stage', String(FIRST));
      });
      lines.add('END_IF;');
    });
    if (this.#answered.length > 0) {
      stage(SENDING, 'sends', () => this.#exchanges.start(RECEIVING, this.#answered));
      stage(RECEIVING, 'the reply comes in', () => this.#receive());
      stage(APART, 'silence between two frames', () => {
        lines.add(`IF ${this.#v('gap timer')}.Q THEN`);
        lines.inside(() => this.#go());
        lines.add('END_IF;');
      });
    }
    if (!this.#waits) return;
    stage(PAUSE, 'waits', () => {
      const stopped = `(${this.#v('stop')} AND NOT ${this.#v('finishing')})`;
      lines.add(`IF ${this.#v('pause timer')}.Q OR ${stopped} THEN`);
      lines.inside(() => this.#go());
      lines.add('END_IF;');
    });
  }

  /** To the stage that follows, or to the finally list if somebody has stopped the steps. */
  #go(): void {
    const { lines } = this.#units;
    lines.add(`IF ${this.#v('stop')} AND NOT ${this.#v('finishing')} THEN`);
    lines.inside(() => this.#set('stage', String(this.#finally)));
    lines.add('ELSE');
    lines.inside(() => this.#set('stage', this.#v('after')));
    lines.add('END_IF;');
  }

  #receive(): void {
    const { lines } = this.#units;
    this.#exchanges.received();
    const each = (write: (request: PlannedRequest) => void) => {
      const [only, ...more] = this.#answered;
      if (only !== undefined && more.length === 0) {
        write(only);
        return;
      }
      lines.add(`CASE ${this.#v('request number')} OF`);
      lines.inside(() => {
        for (const [index, request] of this.#answered.entries()) {
          lines.add(label(this.#units, index + 1, request.about));
          lines.inside(() => write(request));
        }
      });
      lines.add('END_CASE;');
    };
    if (this.#answered.some(({ wanted }) => wanted !== undefined))
      each((request) => this.#set('wanted', this.#exchanges.wanted(request)));
    lines.add(`IF ${this.#exchanges.ended(this.#answered)} THEN`);
    lines.inside(() => {
      each((request) =>
        this.#set('answer', this.#exchanges.check(request, request.list ? this.#listName(request.list) : '')),
      );
      this.#set('stage', String(APART));
    });
    lines.add('END_IF;');
  }
}
