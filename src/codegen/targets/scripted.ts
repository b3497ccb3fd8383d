/**
 * What programs in JavaScript, Python and PowerShell have in common: in which order their parts stand, and the constants
 * that are built.
 * @module
 */
import type { Code, Name } from '../code.ts';
import { type NameRules, Names } from '../names.ts';
import type { BuildArgument, Plan, PlannedRequest, PlannedStep } from '../plan.ts';
import { CodePrinter } from '../print.ts';
import type { Syntax } from '../syntax.ts';
import type { Target } from '../target.ts';
import type { Lines, WrittenFile } from '../written.ts';
import { isAnswered, partsOf, waits } from './shell.ts';

/** The parts that are the same in every program of a language. */
interface Script {
  readonly rules: NameRules;
  readonly syntax: (name: Syntax['name'], code: Code) => Syntax;
  readonly lines: () => Lines;
  /** What the file of a plan is called. */
  readonly fileName: (plan: Plan) => string;
  /** The lines of a part, with or without its comments. */
  readonly partLines: (part: string, comments: boolean) => readonly string[];
  readonly verdict: string;
  /** How the program speaks over the line; `answered` says whether any reply is waited for. */
  readonly exchangeParts: (isTcp: boolean, echo: boolean, answered: boolean) => readonly string[];
  readonly waitUntil: string;
  /** What a sequence needs besides. */
  readonly sequence?: string;
}

/** Writes the program of one plan. */
export abstract class ScriptWriter {
  protected readonly plan: Plan;
  protected readonly lines: Lines;
  protected readonly printer: CodePrinter;
  protected readonly isTcp: boolean;
  protected readonly checks: boolean;
  protected readonly exchanges: boolean;
  /** Whether any request is answered. */
  protected readonly answered: boolean;
  readonly #script: Script;
  readonly #names: Names;

  constructor(script: Script, plan: Plan) {
    const { checks, exchanges } = partsOf(plan);
    this.#script = script;
    this.plan = plan;
    this.lines = script.lines();
    this.isTcp = plan.transport === 'tcp';
    this.checks = checks && plan.requests.some(({ check }) => check !== undefined);
    this.exchanges = exchanges;
    this.answered = plan.requests.some(isAnswered);
    this.#names = new Names(script.rules, plan.options.names);
    this.printer = new CodePrinter(script.syntax(this.#names.of, plan.code), plan.code, plan.options.comments);
  }

  written(): ReturnType<Target['write']> {
    return { files: [this.#file()], notes: this.#names.notes };
  }

  #file(): WrittenFile {
    const { code, options, requests, sequence } = this.plan;
    const { fileName, verdict, exchangeParts, waitUntil, sequence: needed } = this.#script;
    const name = fileName(this.plan);
    this.head(name);
    this.printer.code(this.lines, code);
    if (this.checks) this.#part(verdict);
    if (this.exchanges) for (const part of exchangeParts(this.isTcp, options.echo, this.answered)) this.#part(part);
    this.#frames();
    for (const request of requests) this.request(request);
    if (sequence !== undefined) {
      if (needed !== undefined) this.#part(needed);
      if (waits(sequence)) this.#part(waitUntil);
      this.steps('steps', 'Carries out the steps.', sequence.steps);
      this.steps('finish', 'Carried out at last, in whatever way the steps have ended.', sequence.finally);
    }
    this.main();
    return this.lines.file(name);
  }

  #part(part: string): void {
    this.lines.part();
    for (const line of this.#script.partLines(part, this.plan.options.comments)) this.lines.add(line);
  }

  /** The constants that are built. */
  #frames(): void {
    const built = this.plan.requests.filter(({ build }) => build !== undefined);
    if (built.length > 0) this.lines.part();
    for (const request of built) this.built(this.frame(request), request.build ?? '', request.arguments);
  }

  protected name(name: Name): string {
    return this.printer.name(name, 'routine');
  }

  /** The constant that is sent. */
  protected frame({ name, table }: PlannedRequest): string {
    return this.printer.name(table ?? `${name} frame`, 'table');
  }

  /** What stands before the code. */
  protected abstract head(file: string): void;
  /** A constant that is built by a routine. */
  protected abstract built(constant: string, routine: Name, given: readonly BuildArgument[]): void;
  /** What checks a reply and prints what it says, and what carries the request out. */
  protected abstract request(request: PlannedRequest): void;
  /** The function that carries out steps. */
  protected abstract steps(name: 'steps' | 'finish', about: string, steps: readonly PlannedStep[]): void;
  /** What does what the command line says. */
  protected abstract main(): void;
}

export const scriptTarget = (
  of: Pick<Target, 'id' | 'name' | 'language' | 'proof'>,
  Writer: new (plan: Plan) => ScriptWriter,
): Target => ({
  ...of,
  parts: ['bytes', 'build', 'check', 'exchange'],
  transports: ['rtu', 'ascii', 'tcp', 'pdu'],
  sequences: true,
  write: (plan) => new Writer(plan).written(),
});
