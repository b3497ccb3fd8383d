import type { Name, Parameter } from '../../code.ts';
import type { Plan, PlannedRequest } from '../../plan.ts';
import type { Section, Units, Variable } from './units.ts';

/**
 * What a function block that speaks to a device has, whether it sends one request or carries out a sequence: it is called in
 * every cycle, and a stage follows the other. It knows no serial port: what is sent and received stands in two arrays.
 * @module
 */

const BITS_A_CHARACTER = 11;
const MILLISECONDS = 1000;
/** So long nothing may come in for a reply to be at its end, where no byte says so; at least one cycle of a task. */
const SILENCE = 50;
/** For devices to carry out a broadcast (SL 2.4.1 says 100 ms to 200 ms). */
const TURNAROUND = 100;
/** Characters of silence between two frames (SL 2.5.1.1). */
const CHARACTERS_APART = 3.5;
const LEAST_APART = 2;

/** How one request of a plan is sent, as text. */
export class Exchanges {
  readonly #units: Units;
  readonly #plan: Plan;

  constructor(units: Units, plan: Plan) {
    this.#units = units;
    this.#plan = plan;
  }

  v(name: Name): string {
    return this.#units.dialect.used(name, 'variable');
  }

  get echo(): boolean {
    return this.#plan.options.echo && this.#plan.transport !== 'tcp';
  }

  /** The array in which the reply stands. */
  get reply(): string {
    return this.v(this.echo ? 'reply' : 'rx buffer');
  }

  /** Milliseconds that a frame takes on the line. */
  #lineTime(bytes: number): number {
    if (this.#plan.transport === 'tcp') return 0;
    return Math.ceil((bytes * BITS_A_CHARACTER * MILLISECONDS) / this.#plan.options.line.baud);
  }

  /** How long the reply to the longest of these requests may take, its own sending included. */
  replyTime(requests: readonly PlannedRequest[]): number {
    const longest = Math.max(0, ...requests.map(({ bytes }) => bytes.length));
    return this.#plan.options.timeout + this.#lineTime(longest);
  }

  /** How long a request without a reply takes. */
  broadcastTime(requests: readonly PlannedRequest[]): number {
    return this.#lineTime(Math.max(0, ...requests.map(({ bytes }) => bytes.length))) + TURNAROUND;
  }

  /** Silence between two frames. */
  get gap(): number {
    return Math.max(LEAST_APART, this.#lineTime(CHARACTERS_APART));
  }

  get silence(): number {
    return SILENCE;
  }

  /** Whether silence may end the reply. */
  endsBySilence({ check, wanted }: PlannedRequest): boolean {
    if (check === undefined) return false;
    const routine = this.#units.code.routines.find(({ name }) => name === wanted);
    return routine === undefined || JSON.stringify(routine.body).includes(ZERO_RETURNED);
  }

  /** The variables around a function block. */
  sections(own: {
    readonly inputs: readonly Variable[];
    readonly outputs: readonly Variable[];
    readonly variables: readonly Variable[];
    readonly constants: readonly Variable[];
    readonly requests: readonly PlannedRequest[];
  }): readonly Section[] {
    const { types, timer } = this.#units.dialect;
    const frame = this.#units.frameType;
    const answered = own.requests.some(({ check }) => check !== undefined);
    const silent = own.requests.some((request) => this.endsBySilence(request));
    const timed = own.requests.some(({ wanted }) => wanted !== undefined);
    const received: Variable[] = answered
      ? [
          { name: 'rx buffer', type: frame, comment: 'what has come in; new bytes are appended to it' },
          { name: 'rx count', type: types.int, comment: 'how many bytes; the block sets it to 0 before it sends' },
        ]
      : [];
    return [
      {
        kind: 'VAR_INPUT',
        variables: [{ name: 'execute', type: types.bool, comment: 'a rising edge starts it' }, ...own.inputs],
      },
      { kind: 'VAR_IN_OUT', variables: received },
      {
        kind: 'VAR_OUTPUT',
        variables: [
          { name: 'tx buffer', type: frame, comment: 'what to send' },
          { name: 'tx count', type: types.int, comment: 'how many bytes of it' },
          { name: 'tx start', type: types.bool, comment: 'TRUE for one cycle: send them now' },
          { name: 'busy', type: types.bool, comment: 'TRUE until it has ended' },
          { name: 'done', type: types.bool, comment: 'TRUE if all was well' },
          { name: 'error', type: types.bool, comment: 'TRUE if not: see the result' },
          ...own.outputs,
        ],
      },
      {
        kind: 'VAR',
        variables: [
          { name: 'stage', type: types.int },
          { name: 'was execute', type: types.bool },
          ...(own.requests.length > 0 ? [{ name: 'reply timer', type: timer }] : []),
          ...(silent
            ? [
                { name: 'silence timer', type: timer },
                { name: 'seen count', type: types.int },
              ]
            : []),
          ...(answered ? [{ name: 'reply count', type: types.int }] : []),
          ...(timed ? [{ name: 'wanted', type: types.int }] : []),
          ...(answered && this.echo
            ? [
                { name: 'reply', type: frame },
                { name: 'index', type: types.int },
              ]
            : []),
          ...own.variables,
        ],
      },
      { kind: 'VAR CONSTANT', variables: own.constants },
    ];
  }

  /** The call of the timers, which stands in front of the stages, so that each cycle calls them. */
  timers(receiving: number, requests: readonly PlannedRequest[]): void {
    const { lines } = this.#units;
    const answered = requests.filter(({ check }) => check !== undefined);
    const time = answered.length > 0 ? this.replyTime(requests) : this.broadcastTime(requests);
    const waits = `(${this.v('stage')} = ${receiving})`;
    lines.add(`${this.v('reply timer')}(IN := ${waits}, PT := ${duration(time)});`);
    if (!requests.some((request) => this.endsBySilence(request))) return;
    const [count, seen] = [this.v('rx count'), this.v('seen count')];
    const still = `${waits} AND (${count} > 0) AND (${count} = ${seen})`;
    lines.add(`${this.v('silence timer')}(IN := ${still}, PT := ${duration(SILENCE)});`);
    lines.add(`${seen} := ${count};`);
  }

  /** Puts the request into the array and says that it is to be sent. */
  send(request: PlannedRequest, given: (parameter: Name) => string): void {
    const { lines } = this.#units;
    lines.add(`${this.v('tx count')} := ${this.build(request, given)};`);
  }

  build(request: PlannedRequest, given: (parameter: Name) => string): string {
    const units = this.#units;
    const frame = ['frame', this.v('tx buffer')] as const;
    if (request.build === undefined) return units.call(frameRoutine(request), frame);
    const parameters = request.arguments.map(({ parameter: { name } }) => [name, given(name)] as const);
    return units.call(request.build, ...parameters, frame);
  }

  start(receiving: number, requests: readonly PlannedRequest[]): void {
    const { lines } = this.#units;
    if (requests.some(({ check }) => check !== undefined)) lines.add(`${this.v('rx count')} := 0;`);
    lines.add(`${this.v('tx start')} := TRUE;`);
    lines.add(`${this.v('stage')} := ${receiving};`);
  }

  /** What has come in so far, without the echo in front of it. */
  received(): void {
    const { lines } = this.#units;
    const [count, rx] = [this.v('reply count'), this.v('rx count')];
    if (!this.echo) {
      lines.add(`${count} := ${rx};`);
      return;
    }
    const [index, sent] = [this.v('index'), this.v('tx count')];
    this.#units.printer.remark(lines, 'The adapter gives back what is sent: the reply comes after it.');
    lines.add(`${count} := ${rx} - ${sent};`);
    lines.add(`IF ${count} < 0 THEN`).inside(() => lines.add(`${count} := 0;`));
    lines.add('END_IF;');
    lines.add(`FOR ${index} := 0 TO ${count} - 1 DO`);
    lines.inside(() => lines.add(`${this.v('reply')}[${index}] := ${this.v('rx buffer')}[${sent} + ${index}];`));
    lines.add('END_FOR;');
  }

  wanted({ wanted }: PlannedRequest): string {
    if (wanted === undefined) return '0';
    const [reply, length] = this.#units.parametersOf(wanted);
    return this.#units.call(wanted, [reply?.name ?? '', this.reply], [length?.name ?? '', this.v('reply count')]);
  }

  /** The condition under which the whole reply is there, or the time is over. */
  ended(requests: readonly PlannedRequest[]): string {
    const silent = requests.some((request) => this.endsBySilence(request));
    const counted = requests.some(({ wanted }) => wanted !== undefined);
    const [wanted, count] = [this.v('wanted'), this.v('reply count')];
    const over = `${this.v('reply timer')}.Q`;
    const quiet = `${this.v('silence timer')}.Q`;
    if (!counted) return `((${count} > 0) AND ${quiet}) OR ${over}`;
    if (!silent) return `(${count} >= ${wanted}) OR ${over}`;
    const whole = `(${wanted} > 0) AND (${count} >= ${wanted})`;
    return `(${whole}) OR ((${wanted} = 0) AND (${count} > 0) AND ${quiet}) OR ${over}`;
  }

  /** How many elements of the list the reply fills. */
  items({ routine, takes }: NonNullable<PlannedRequest['items']>): string {
    const parameters = this.#units.parametersOf(routine);
    const given = takes.map((what, index) => {
      const value = what === 'reply' ? this.reply : this.v('reply count');
      return [parameters[index]?.name ?? '', value] as const;
    });
    return this.#units.call(routine, ...given);
  }

  check(request: PlannedRequest, list: Name): string {
    if (request.check === undefined) throw new TypeError('a broadcast has no check');
    const given = ({ name, size, filled }: Parameter): string => {
      if (size === undefined) return this.v('reply count');
      if (filled) return this.v(list);
      return name === 'request' ? this.v('tx buffer') : this.reply;
    };
    const parameters = this.#units.parametersOf(request.check);
    return this.#units.call(request.check, ...parameters.map((one) => [one.name, given(one)] as const));
  }
}

const ZERO_RETURNED = '{"kind":"return","value":{"kind":"number","type":"int","value":0,';

/** The function that gives the bytes of a request that has no parameters. */
export const frameRoutine = ({ table, name }: PlannedRequest): Name => table ?? `${name} frame`;

export const duration = (milliseconds: number): string => `T#${Math.round(milliseconds)}ms`;
