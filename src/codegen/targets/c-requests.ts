import type { Scalar } from '../code.ts';
import type { PlannedRequest, PlannedSequence, PlannedStep } from '../plan.ts';
import type { Printer } from '../syntax.ts';
import type { Lines } from '../written.ts';
import { cString } from './c-syntax.ts';

/** In what programs of C and of Arduino differ where they use the routines of a request. */
export interface CDialect {
  /** The type of an `int` that is a result. */
  readonly result: string;
  /** What copies bytes of a table, and what waits for milliseconds. */
  readonly copy: string;
  readonly wait: string;
  /** The parameter of what speaks to the device, and the argument with what parts it from the next. */
  readonly port: { readonly parameter: string; readonly argument: string };
  /** Statements that print a value, with its name and unit; and element `i` of an array. */
  readonly value: (type: Scalar, name: string, value: string, unit: string) => readonly string[];
  readonly element: (type: Scalar, array: string) => readonly string[];
}

/** Whether a sequence has a step of a kind. */
export const hasStep = (kind: PlannedStep['kind'], { steps, finally: last }: PlannedSequence): boolean => {
  const within = (list: readonly PlannedStep[]): boolean =>
    list.some((step) => step.kind === kind || (step.kind === 'repeat' && within(step.steps)));
  return within(steps) || within(last);
};

/** Writes what belongs to the requests, each under one name, and the steps that send them. */
export class RequestWriter {
  readonly #lines: Lines;
  readonly #printer: Printer;
  readonly #type: (type: Scalar) => string;
  readonly #dialect: CDialect;

  /** `type` writes the type of a number. */
  constructor(lines: Lines, printer: Printer, type: (type: Scalar) => string, dialect: CDialect) {
    this.#type = type;
    this.#lines = lines;
    this.#printer = printer;
    this.#dialect = dialect;
  }

  /** What belongs to each request, and a list of all where they are sent one after another. */
  requests(requests: readonly PlannedRequest[], listed: boolean): void {
    for (const request of requests) this.#request(request);
    if (!listed) return;
    const list = requests.map((request) => `&${this.#variable(request)},`);
    this.#lines.add('');
    this.#block('static const struct request *const requests[] = {', list, '};');
  }

  sequence({ steps, finally: last }: PlannedSequence): void {
    this.#steps('The steps. Returns whether they were carried out to their end.', 'bool run_steps', steps, true);
    this.#steps('What is done at last, however the steps ended.', 'void run_finally', last, false);
  }

  #name(name: string): string {
    return this.#printer.name(name, 'routine');
  }

  #variable({ name }: PlannedRequest): string {
    return this.#printer.name(`${name} request`, 'variable');
  }

  #block(head: string, body: readonly string[], end = '}'): void {
    this.#lines.add(head).inside(() => {
      for (const line of body) this.#lines.add(line);
    });
    this.#lines.add(end);
  }

  #request(request: PlannedRequest): void {
    const { name, about, check, wanted } = request;
    const [make, show] = [this.#name(`make ${name}`), this.#name(`show ${name}`)];
    this.#lines.add('');
    this.#printer.remark(this.#lines, about);
    this.#lines.add(`static int ${make}(uint8_t *frame)`);
    this.#block('{', this.#make(request));
    if (check !== undefined) {
      const { result } = this.#dialect;
      this.#lines.add('');
      this.#lines.add(`static ${result} ${show}(const uint8_t *request, const uint8_t *reply, int reply_length)`);
      this.#lines.add('{').inside(() => this.#show(request, check));
      this.#lines.add('}');
    }
    const routines = [make, check === undefined ? 'NULL' : show, wanted === undefined ? 'NULL' : this.#name(wanted)];
    this.#lines.add('');
    this.#block(
      `static const struct request ${this.#variable(request)} = {`,
      [`${[cString(name), ...routines].join(', ')},`],
      '};',
    );
  }

  /** The frame with the values that it has in the request. */
  #make({ build, table, arguments: given }: PlannedRequest): readonly string[] {
    const printer = this.#printer;
    if (build === undefined) {
      const bytes = printer.name(table ?? '', 'table');
      return [`${this.#dialect.copy}(frame, ${bytes}, sizeof ${bytes});`, `return sizeof ${bytes};`];
    }
    const arrays: string[] = [];
    const values = given.map(({ parameter: { name, type }, value, scaled = [] }) => {
      const text = (of: number, index: number) => {
        const inUnits = scaled.find((one) => one.index === index);
        if (inUnits) return `${this.#name(inUnits.routine)}(${this.#number('real', inUnits.value)})`;
        return type === 'bool' ? String(of !== 0) : this.#number(type, of);
      };
      if (typeof value === 'number') return text(value, 0);
      arrays.push(...this.#array(scaled.length === 0, printer.name(name), type, value.map(text)));
      return printer.name(name);
    });
    return [...arrays, `return ${this.#name(build)}(${['frame', ...values].join(', ')});`];
  }

  #number(type: Scalar, value: number): string {
    return this.#printer.syntax.number({ kind: 'number', type, value, base: 10 });
  }

  #array(isConstant: boolean, name: string, type: Scalar, values: readonly string[]): readonly string[] {
    const head = `${isConstant ? 'static ' : ''}const ${this.#type(type)} ${name}[${values.length}] = {`;
    const line = `${head}${values.join(', ')}};`;
    if (line.length <= WIDEST) return [line];
    const rows = values.flatMap((_, at) => (at % ROW === 0 ? [`    ${values.slice(at, at + ROW).join(', ')},`] : []));
    return [head, ...rows, '};'];
  }

  /** Prints what the reply says. */
  #show({ name, list, items, values }: PlannedRequest, check: string): void {
    const lines = this.#lines;
    const { result, element, value } = this.#dialect;
    const array = list === undefined ? [] : [this.#printer.name(list.name)];
    if (list) lines.add(`${this.#type(list.type)} ${array[0]}[${list.size}] = {0};`);
    const checked = `report(${cString(name)}, ${this.#name(check)}(${['request', 'reply', 'reply_length', ...array].join(', ')}))`;
    if (list === undefined && values.length === 0) {
      lines.add(`return ${checked};`);
      return;
    }
    lines.add(`${result} result = ${checked};`);
    this.#block('if (result != 0) {', ['return result;']);
    const takes = items?.takes.map((one) => (one === 'reply' ? 'reply' : 'reply_length')) ?? [];
    const many = items === undefined ? list?.size : `${this.#name(items.routine)}(${takes.join(', ')})`;
    if (list) this.#block(`for (int i = 0; i < ${many}; i++) {`, element(list.type, array[0] ?? ''));
    for (const { routine, name: called, type: of, unit } of values)
      for (const line of value(of, called, `${this.#name(routine)}(reply)`, unit)) lines.add(line);
    lines.add('return 0;');
  }

  #steps(about: string, head: string, steps: readonly PlannedStep[], mayEnd: boolean): void {
    const lines = this.#lines;
    const { parameter } = this.#dialect.port;
    lines.add('');
    this.#printer.remark(lines, about);
    lines.add(`static ${head}(${parameter})`).add('{');
    lines.inside(() => {
      if (parameter !== 'void' && steps.every(({ kind }) => kind === 'wait')) lines.add('(void)port;');
      this.#list(steps, mayEnd, 0);
      if (mayEnd) lines.add('return true;');
    });
    lines.add('}');
  }

  #list(steps: readonly PlannedStep[], mayEnd: boolean, depth: number): void {
    const lines = this.#lines;
    for (const step of steps) {
      this.#printer.remark(lines, step.about);
      if (step.kind === 'wait') lines.add(`${this.#dialect.wait}(${step.duration});`);
      else if (step.kind === 'repeat') {
        const counter = `round_${depth + 1}`;
        lines.add(`for (long ${counter} = 0; ${counter} < ${step.times}; ${counter}++) {`);
        lines.inside(() => this.#list(step.steps, mayEnd, depth + 1)).add('}');
      } else {
        const what = `${this.#dialect.port.argument}&${this.#variable(step.request)}`;
        const call =
          step.kind === 'send'
            ? `ask(${what})`
            : `ask_until(${what}, ${this.#name(step.holds)}, ${step.interval}, ${step.timeout})`;
        if (mayEnd && step.stops) this.#block(`if (!${call}) {`, ['return false;']);
        else lines.add(`${call};`);
      }
    }
  }
}

const WIDEST = 100;
const ROW = 12;
