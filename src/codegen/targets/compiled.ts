/**
 * What programs in C#, Java, Go and Rust have in common: in which order their parts stand. What each part is written like, a
 * `Dialect` says, in texts set in by four blanks.
 * @module
 */
import type { Code, Name, Parameter, Scalar } from '../code.ts';
import { type NameRules, Names } from '../names.ts';
import type { BuildArgument, Plan, PlannedRequest, PlannedStep } from '../plan.ts';
import { CodePrinter } from '../print.ts';
import type { Remarked, Syntax } from '../syntax.ts';
import type { Target } from '../target.ts';
import { Lines, type WrittenFile } from '../written.ts';
import { isAnswered, itemsCall, partsOf, programAbout, programName } from './shell.ts';

/** What a program has, of all that it could have. */
export interface Shape {
  readonly plan: Plan;
  readonly isTcp: boolean;
  readonly checks: boolean;
  readonly exchanges: boolean;
  /** Whether any request is answered, so that something is received. */
  readonly receives: boolean;
  /** Whether any request on a serial line is not answered, so that the devices are given time. */
  readonly turnsAround: boolean;
  readonly waitsUntil: boolean;
  /** Whether a failure of a step is ever gone past. */
  readonly attempts: boolean;
  readonly waits: boolean;
  /** Libraries that the code needs, as its syntax found. */
  readonly uses: ReadonlySet<string>;
  /** The class that holds all. */
  readonly className: string;
  /** The routines that say an exception and a fault in words. */
  readonly exceptionName: string;
  readonly faultName: string;
}

/** A request as its parts are written: names and texts as they stand in the program. */
export interface Shown {
  /** What is printed before the verdict of a check, and what is said of a failure. */
  readonly title: string;
  readonly failure: string;
  readonly frame: string;
  readonly show: string;
  readonly send: string;
  readonly check: string | undefined;
  readonly wanted: string | undefined;
  readonly list: Parameter | undefined;
  /** Tells how many elements of the list the reply fills, if not all. */
  readonly items: string | undefined;
  readonly values: readonly {
    readonly label: string;
    readonly call: string;
    readonly unit: string;
    readonly type: Scalar;
  }[];
}

export interface Dialect {
  /** The length of `reply`, as an `int` of `Code`. */
  readonly length: string;
  readonly rules: NameRules;
  readonly ending: string;
  /** What a line is set in by. */
  readonly indent: string;
  /** The class that holds all, if one does. */
  readonly isClass: boolean;
  readonly syntax: (name: Syntax['name'], code: Code, uses: Set<string>) => Syntax;
  readonly quoted: (text: string) => string;
  /** What is written instead of a line that is a comment of documentation; the line as it is by default. */
  readonly documentation?: (text: string) => string;
  readonly head: (lines: readonly string[]) => string;
  readonly imports: (shape: Shape) => string;
  readonly open: (name: string) => string;
  /** How the program is started, before its arguments. */
  readonly command: (name: string, file: string) => string;
  readonly settings: (shape: Shape) => readonly Remarked[];
  /** An array that is given to a routine; an element of it, where it is not written as any number. */
  readonly list: (parameter: Parameter, items: readonly string[]) => string;
  readonly item?: (parameter: Parameter, value: number, text: string) => string;
  /** What is built is a constant or a function: how it is written, and read. */
  readonly built: 'table' | 'routine';
  readonly frame: (name: string, call: string) => string;
  readonly readFrame: (name: string, isBuilt: boolean) => string;
  readonly shared: (shape: Shape) => readonly string[];
  readonly show: (shown: Shown) => string;
  readonly send: (shown: Shown, shape: Shape) => string;
  readonly step: StepTexts;
  /** The function that carries out steps; `last` if it is those of finally, and `idle` if none of them uses the line. */
  readonly steps: (
    name: string,
    about: string,
    line: string,
    last: boolean,
    idle: boolean,
  ) => readonly [head: string, end: string];
  readonly line: (shape: Shape) => string;
  readonly main: (shown: readonly Shown[], shape: Shape) => string;
}

interface StepTexts {
  readonly wait: (milliseconds: number) => string;
  readonly repeat: (times: number, depth: number) => readonly [head: string, end: string];
  readonly send: (shown: Shown, stops: boolean) => string;
  readonly until: (
    shown: Shown,
    until: { readonly holds: string; readonly interval: number; readonly timeout: number; readonly about: string },
    stops: boolean,
  ) => string;
}

/** Variables of the parts that call the code. What has another use is called otherwise. */
const LOCALS: readonly Name[] = [
  'request',
  'reply',
  'frame',
  'length',
  'values',
  'index',
  'bytes',
  'count',
  'received',
];

const DOCUMENTATION = /^\/\*\* (.*) \*\/$/;
const REMARK = /^\s*(\/\/|\/\*\*|\* |\*\/)/;
const BLANKS = / {4}/g;

class Writer {
  readonly #dialect: Dialect;
  readonly #plan: Plan;
  readonly #shape: Shape;
  readonly #lines: Lines;
  readonly #printer: CodePrinter;
  readonly #names: Names;

  constructor(dialect: Dialect, plan: Plan) {
    this.#dialect = dialect;
    this.#plan = plan;
    const { requests, sequence, options, code } = plan;
    const { checks, exchanges } = partsOf(plan);
    const written = JSON.stringify(sequence ?? {});
    const uses = new Set<string>();
    this.#names = new Names(dialect.rules, options.names);
    for (const local of LOCALS) this.#names.keep(local, 'variable');
    this.#shape = {
      className: this.#names.of(programName(plan), 'type'),
      exceptionName: this.#names.of('exception name', 'routine'),
      faultName: this.#names.of('fault name', 'routine'),
      plan,
      isTcp: plan.transport === 'tcp',
      checks: checks && requests.some(({ check }) => check !== undefined),
      exchanges,
      receives: exchanges && requests.some(isAnswered),
      turnsAround: exchanges && plan.transport !== 'tcp' && !requests.every(isAnswered),
      waitsUntil: written.includes('"kind":"until"'),
      waits: written.includes('"kind":"wait"') || written.includes('"kind":"until"'),
      attempts: written.includes('"stops":false') || (sequence?.finally ?? []).some(({ kind }) => kind !== 'wait'),
      uses,
    };
    this.#printer = new CodePrinter(dialect.syntax(this.#names.of, code, uses), code, options.comments);
    this.#lines = new Lines(dialect.indent);
  }

  file(): { readonly file: WrittenFile; readonly names: Names } {
    const dialect = this.#dialect;
    const { code, options } = this.#plan;
    const { className: type } = this.#shape;
    const file = `${type}${dialect.ending}`;
    const body = () => {
      this.#settings();
      this.#printer.code(this.#lines, code);
      this.#frames();
      for (const text of dialect.shared(this.#shape)) this.#part(text);
      const shown = this.#plan.requests.map((request) => this.#shown(request));
      for (const one of shown) {
        if (this.#shape.checks && one.check !== undefined) this.#part(dialect.show(one));
        if (this.#shape.exchanges) this.#part(dialect.send(one, this.#shape));
      }
      this.#sequence();
      this.#part(dialect.main(shown, this.#shape));
    };
    // The code tells which libraries it needs only when it is printed: it is printed once for that.
    this.#printer.code(new Lines(dialect.indent), code);
    if (options.comments) this.#text(dialect.head(this.#about(type, file)));
    this.#lines.text(dialect.imports(this.#shape)).add('');
    if (dialect.isClass) {
      this.#lines.add(dialect.open(type)).inside(body).add('}');
    } else body();
    return { file: this.#lines.file(file), names: this.#names };
  }

  #about(type: string, file: string): readonly string[] {
    const { checks, exchanges, isTcp } = this.#shape;
    const command = this.#dialect.command(type, file);
    const isSequence = this.#plan.sequence !== undefined;
    return [
      programAbout(this.#plan),
      '',
      ...(exchanges ? [`${command} [${isTcp ? 'HOST' : 'PORT'}]: carries it out`] : []),
      ...(isSequence ? [] : [`${command}${exchanges ? ' --bytes' : ''}: prints what is sent`]),
      ...(checks && !isSequence ? [`${command} --check HEX: checks a reply`] : []),
    ];
  }

  /** Lines that are set in by four blanks, without comments if there are to be none. */
  #text(text: string): void {
    for (const line of text.split('\n')) {
      const whole = line.trimEnd();
      if (!this.#plan.options.comments && REMARK.test(whole)) continue;
      const said = DOCUMENTATION.exec(whole)?.[1];
      if (said !== undefined && this.#dialect.documentation) {
        this.#lines.add(this.#dialect.documentation(said));
        continue;
      }
      const blanks = whole.length - whole.trimStart().length;
      this.#lines.add(whole.slice(0, blanks).replace(BLANKS, this.#dialect.indent) + whole.trimStart());
    }
  }

  #part(text: string): void {
    this.#lines.add('');
    this.#text(text.replace(/^\n|\n\s*$/g, ''));
  }

  #settings(): void {
    const rows = this.#dialect.settings(this.#shape);
    if (rows.length === 0) return;
    this.#printer.group(this.#lines, rows);
  }

  #name(name: Name): string {
    return this.#printer.name(name, 'routine');
  }

  #frameName({ name, table }: PlannedRequest): string {
    return this.#names.of(table ?? `${name} frame`, table === undefined ? this.#dialect.built : 'table');
  }

  /** What a routine is given for a parameter; what is in units goes through the routine that makes a register of it. */
  #given({ parameter, value, scaled = [] }: BuildArgument): string {
    const { type } = parameter;
    const literal = (of: number, as: Scalar = type): string =>
      as === 'bool' ? String(of !== 0) : this.#printer.syntax.number({ kind: 'number', type: as, value: of, base: 10 });
    const text = (of: number, at: number): string => {
      const units = scaled.find(({ index }) => index === at);
      return units ? `${this.#name(units.routine)}(${literal(units.value, 'real')})` : literal(of);
    };
    if (typeof value === 'number') return text(value, 0);
    const { list, item = (_, __, of) => of } = this.#dialect;
    return list(
      parameter,
      value.map((of, at) => item(parameter, of, text(of, at))),
    );
  }

  #frames(): void {
    const built = this.#plan.requests.filter(({ build }) => build !== undefined);
    for (const request of built) {
      this.#lines.add('');
      const { build = '', arguments: given } = request;
      const texts = given
        .filter(({ parameter }) => parameter.lengthOf === undefined || this.#printer.syntax.slices === undefined)
        .map((one) => this.#given(one));
      this.#printer.remark(this.#lines, request.about);
      this.#text(this.#dialect.frame(this.#frameName(request), `${this.#name(build)}(${texts.join(', ')})`));
    }
  }

  #shown(request: PlannedRequest): Shown {
    const { name, about, check, wanted, list, values, build } = request;
    const { quoted, readFrame, length } = this.#dialect;
    return {
      title: quoted(`${about}:`),
      failure: quoted(`failed: ${about}`),
      frame: readFrame(this.#frameName(request), build !== undefined),
      show: this.#name(`show ${name}`),
      send: this.#name(`send ${name}`),
      check: check && this.#name(check),
      wanted: wanted && this.#name(wanted),
      list,
      items: itemsCall(request, (routine) => this.#name(routine), length, this.#printer.syntax.slices !== undefined),
      values: values.map((value) => ({
        label: quoted(`${value.name} =`),
        call: `${this.#name(value.routine)}(reply)`,
        unit: value.unit === '' ? '' : quoted(value.unit),
        type: value.type,
      })),
    };
  }

  #sequence(): void {
    const { sequence } = this.#plan;
    if (sequence === undefined) return;
    this.#steps('steps', 'Carries out the steps.', sequence.steps, false);
    if (sequence.finally.length > 0)
      this.#steps('finish', 'Carried out at last, in whatever way the steps have ended.', sequence.finally, true);
  }

  #steps(name: string, about: string, steps: readonly PlannedStep[], last: boolean): void {
    const isIdle = !JSON.stringify(steps).includes('"request"');
    const [head, end] = this.#dialect.steps(name, about, this.#dialect.line(this.#shape), last, isIdle);
    this.#part(head);
    this.#lines.inside(() => this.#body(steps, last, 0));
    this.#text(end);
  }

  #body(steps: readonly PlannedStep[], last: boolean, depth: number): void {
    const { step: texts } = this.#dialect;
    for (const step of steps) {
      this.#printer.remark(this.#lines, step.about);
      if (step.kind === 'wait') this.#text(texts.wait(step.duration));
      else if (step.kind === 'send') this.#text(texts.send(this.#shown(step.request), step.stops && !last));
      else if (step.kind === 'until') {
        const { interval, timeout, about } = step;
        const until = { holds: this.#name(step.holds), interval, timeout, about: this.#dialect.quoted(about) };
        this.#text(texts.until(this.#shown(step.request), until, step.stops && !last));
      } else {
        const [head, end] = texts.repeat(step.times, depth);
        this.#text(head);
        this.#lines.inside(() => this.#body(step.steps, last, depth + 1));
        this.#text(end);
      }
    }
  }
}

export const compiledTarget = (of: Pick<Target, 'id' | 'name' | 'language'>, dialect: Dialect): Target => ({
  ...of,
  proof: 'run',
  parts: ['bytes', 'build', 'check', 'exchange'],
  transports: ['rtu', 'ascii', 'tcp', 'pdu'],
  sequences: true,
  write: (plan) => {
    const { file, names } = new Writer(dialect, plan).file();
    return { files: [file], notes: names.notes };
  },
});
