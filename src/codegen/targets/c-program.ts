import { MOST_ASCII, MOST_RTU, MOST_TCP } from '../../modbus/index.ts';
import { type NameRules, Names } from '../names.ts';
import type { Plan, PlannedRequest, ProgramNote } from '../plan.ts';
import { CodePrinter } from '../print.ts';
import type { Target } from '../target.ts';
import { Lines, type WrittenFile } from '../written.ts';
import { type CDialect, hasStep, RequestWriter } from './c-requests.ts';
import { type CFamily, cSyntax, cType, withoutComments } from './c-syntax.ts';
import { partsOf, programName } from './shell.ts';

/** The bytes of the longest frame. */
const MOST = { rtu: MOST_RTU, ascii: MOST_ASCII, tcp: MOST_TCP, pdu: MOST_RTU } as const;

interface Kind {
  readonly rules: NameRules;
  /** `own` stands before what only this file uses. */
  readonly family: (own: string, names: Names) => CFamily;
  readonly dialect: CDialect;
  /** With its dot. */
  readonly ending: string;
}

/** Writes the program of one plan in C or in what an Arduino understands of C++. */
export abstract class CWriter {
  protected readonly plan: Plan;
  protected readonly lines = new Lines('    ');
  protected readonly printer: CodePrinter;
  /** Whether the program speaks to the device. */
  protected readonly speaks: boolean;
  protected readonly notes: ProgramNote[] = [];
  readonly #kind: Kind;
  readonly #names: Names;

  constructor(kind: Kind, plan: Plan) {
    this.#kind = kind;
    this.plan = plan;
    this.speaks = plan.transport !== 'pdu' && partsOf(plan).exchanges;
    this.#names = new Names(kind.rules, plan.options.names);
    this.printer = new CodePrinter(cSyntax(kind.family(this.own, this.#names)), plan.code, plan.options.comments);
  }

  written(): ReturnType<Target['write']> {
    const { code, options } = this.plan;
    const printed = new Lines('    ');
    this.printer.code(printed, code);
    const name = this.#names.of(programName(this.plan), 'routine');
    this.head(name, printed.file('').text);
    this.printer.code(this.lines, code);
    if (this.speaks) this.exchange();
    else if (options.part === 'exchange') this.notes.push({ code: 'not-offered', what: 'exchange' });
    const file: WrittenFile = this.lines.file(`${name}${this.#kind.ending}`);
    return { files: [file], notes: [...this.notes, ...this.#names.notes] };
  }

  /** What stands before what only this file uses. */
  protected get own(): string {
    return this.speaks ? 'static ' : '';
  }

  protected get mostBytes(): number {
    return MOST[this.plan.transport];
  }

  /** A part that is the same in every program. */
  protected part(text: string): void {
    this.lines.add('').text(this.plan.options.comments ? text : withoutComments(text));
  }

  /** What belongs to each request; `listed` makes a list of all. */
  protected requests(requests: readonly PlannedRequest[], listed: boolean): void {
    this.#requests().requests(requests, listed);
  }

  /** The steps, with the part that waits for a condition if any step does. */
  protected sequence(until: string): void {
    const { sequence } = this.plan;
    if (sequence === undefined) return;
    if (hasStep('until', sequence)) this.part(until);
    this.#requests().sequence(sequence);
  }

  #requests(): RequestWriter {
    const { family, dialect } = this.#kind;
    return new RequestWriter(this.lines, this.printer, (type) => cType(family('', this.#names), type), dialect);
  }

  /** What stands before the code, which is also given as it is printed. */
  protected abstract head(name: string, printed: string): void;
  /** What speaks to the device. */
  protected abstract exchange(): void;
}

export const cTarget = (of: Pick<Target, 'id' | 'name' | 'language'>, Writer: new (plan: Plan) => CWriter): Target => ({
  ...of,
  proof: 'run',
  parts: ['bytes', 'build', 'check', 'exchange'],
  transports: ['rtu', 'ascii', 'tcp', 'pdu'],
  sequences: true,
  write: (plan) => new Writer(plan).written(),
});
