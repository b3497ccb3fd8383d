import type { Name } from '../code.ts';
import type { BuildArgument, Plan, PlannedRequest, PlannedStep } from '../plan.ts';
import { Lines } from '../written.ts';
import { quoted } from './c-like.ts';
import { javascriptRules } from './javascript-names.ts';
import { exchangeParts, partLines, VERDICT, WAIT_UNTIL } from './javascript-shell.ts';
import { javascriptSyntax, jsdoc } from './javascript-syntax.ts';
import { ScriptWriter, scriptTarget } from './scripted.ts';
import { argumentTexts, isAnswered, itemsCall, pauseOf, programAbout, programName, SILENCE } from './shell.ts';

/** Writes the program of one plan. */
class Writer extends ScriptWriter {
  constructor(plan: Plan) {
    super(
      {
        rules: javascriptRules,
        syntax: javascriptSyntax,
        lines: () => new Lines(),
        fileName: (of) => `${programName(of).replaceAll(' ', '-')}.mjs`,
        partLines,
        verdict: VERDICT,
        exchangeParts,
        waitUntil: WAIT_UNTIL,
      },
      plan,
    );
  }

  /** A function of the shell. */
  #define(head: string, about: string, body: () => void): void {
    this.lines.part();
    if (this.plan.options.comments) for (const line of jsdoc([about])) this.lines.add(line);
    this.lines.add(`${head} {`).inside(body).add('}');
  }

  protected override head(name: string): void {
    const { options, sequence } = this.plan;
    const lines = this.lines;
    const about = [programAbout(this.plan)];
    if (this.exchanges) about.push(`node ${name} [${this.isTcp ? 'HOST' : 'PORT'}]  carries it out`);
    if (sequence === undefined) about.push(`node ${name} --bytes  prints what is sent`);
    if (sequence === undefined && this.checks) about.push(`node ${name} --check HEX  checks a reply`);
    if (this.exchanges && !this.isTcp) about.push('It needs serialport: npm install serialport');
    this.printer.remark(lines, ...about);
    lines.add('');
    const { answered } = this;
    const sleeps = this.exchanges && (!this.isTcp || sequence !== undefined);
    if (this.exchanges && (answered || this.isTcp)) lines.add('import { once } from "node:events";');
    if (this.exchanges && this.isTcp) lines.add('import { connect } from "node:net";');
    if (sleeps) lines.add('import { setTimeout as sleep } from "node:timers/promises";');
    lines.add('import { fileURLToPath } from "node:url";');
    if (!this.exchanges) return;
    if (!this.isTcp) lines.add('import { SerialPort } from "serialport";');
    lines.add('');
    const timeout = {
      text: `const TIMEOUT = ${options.timeout};`,
      comment: 'milliseconds from the end of the request to the whole reply',
    };
    this.printer.aligned(lines, [...this.#line(answered), ...(answered || this.isTcp ? [timeout] : [])]);
  }

  /** The settings of the line. */
  #line(answered: boolean) {
    const { options } = this.plan;
    const { host, port: tcpPort } = options.server;
    if (this.isTcp) return [{ text: `const HOST = ${quoted(host)};` }, { text: `const PORT = ${tcpPort};` }];
    const { port, baud, dataBits, parity, stopBits } = options.line;
    const line = `{ baudRate: ${baud}, dataBits: ${dataBits}, parity: "${parity}", stopBits: ${stopBits} }`;
    return [
      { text: `const PORT = ${quoted(port)};` },
      { text: `const LINE = ${line};` },
      { text: `const PAUSE = ${pauseOf(options)};`, comment: 'milliseconds of silence between two frames' },
      ...(answered
        ? [
            {
              text: `const SILENCE = ${SILENCE};`,
              comment: 'milliseconds of silence that end a reply of unknown length',
            },
          ]
        : []),
    ];
  }

  #given(argument: BuildArgument): string {
    const { type } = argument.parameter;
    const texts = argumentTexts(
      argument,
      (value) =>
        type === 'bool' ? String(value !== 0) : this.printer.syntax.number({ kind: 'number', type, value, base: 10 }),
      ({ routine, value }) => `${this.name(routine)}(${value})`,
    ).join(', ');
    if (typeof argument.value === 'number') return texts;
    return type === 'byte' ? `Uint8Array.of(${texts})` : `[${texts}]`;
  }

  protected override built(constant: string, routine: Name, given: readonly BuildArgument[]): void {
    const counted = given.filter(({ parameter }) => parameter.lengthOf === undefined);
    this.printer.remark(this.lines, counted.map(({ parameter }) => parameter.name).join(', '));
    const call = `${this.name(routine)}(${counted.map((one) => this.#given(one)).join(', ')})`;
    this.lines.add(`export const ${constant} = ${call};`);
  }

  /** What checks the reply and prints what it says, and what carries the request out. */
  protected override request(request: PlannedRequest): void {
    const { name, about, check, wanted, list } = request;
    const lines = this.lines;
    const frame = this.frame(request);
    const [show, send] = [this.name(`show ${name}`), this.name(`send ${name}`)];
    if (this.checks && check !== undefined) {
      this.#define(`function ${show}(reply)`, 'Prints what a reply says; gives whether it is good.', () => {
        if (list?.size !== undefined) {
          const zero = list.type === 'bool' ? 'false' : '0';
          lines.add(
            list.type === 'byte'
              ? `const values = new Uint8Array(${list.size});`
              : `const values = new Array(${list.size}).fill(${zero});`,
          );
        }
        lines.add(`const result = ${this.name(check)}(${frame}, reply${list ? ', values' : ''});`);
        lines.add(`console.log(${quoted(`${about}:`)}, verdict(result));`);
        this.#values(request);
        lines.add('return result === 0;');
      });
    }
    if (!this.exchanges) return;
    if (check !== undefined && wanted !== undefined) {
      this.#define(`async function ${send}(line)`, `${about}. Gives the reply, if it is good.`, () => {
        lines.add(`const reply = await exchange(line, ${frame}, ${this.name(wanted)});`);
        lines.add(`return ${show}(reply) ? reply : undefined;`);
      });
    } else {
      this.#define(`async function ${send}(line)`, `${about}. No reply comes.`, () => {
        lines.add(`await send(line, ${frame});`).add('return new Uint8Array();');
      });
    }
  }

  #values(request: PlannedRequest): void {
    const { values, list } = request;
    const items = itemsCall(request, (routine) => this.name(routine), 'reply.length', true);
    if (values.length === 0 && list === undefined) return;
    const lines = this.lines;
    lines.add('if (result === 0) {').inside(() => {
      for (const { name, routine, unit } of values) {
        const parts = [quoted(`${name} =`), `${this.name(routine)}(reply)`, ...(unit === '' ? [] : [quoted(unit)])];
        lines.add(`console.log(${parts.join(', ')});`);
      }
      if (list !== undefined)
        lines.add(
          `console.log(${quoted(`${list.name}:`)}, ...values${items === undefined ? '' : `.slice(0, ${items})`});`,
        );
    });
    lines.add('}');
  }

  protected override steps(name: 'steps' | 'finish', about: string, steps: readonly PlannedStep[]): void {
    if (steps.length > 0)
      this.#define(`async function ${name}(line)`, about, () => this.#body(steps, name === 'steps', 1));
  }

  #body(steps: readonly PlannedStep[], mayStop: boolean, depth: number): void {
    const lines = this.lines;
    const orFail = (call: string, about: string, stops: boolean) => {
      if (!stops || !mayStop) lines.add(`await ${call};`);
      else lines.add(`if (!(await ${call})) throw new Error(${quoted(`${about}: failed`)});`);
    };
    for (const step of steps) {
      this.printer.remark(lines, step.about);
      if (step.kind === 'wait') lines.add(`await sleep(${step.duration});`);
      if (step.kind === 'send')
        orFail(`${this.name(`send ${step.request.name}`)}(line)`, step.about, step.stops && isAnswered(step.request));
      if (step.kind === 'repeat') {
        const turn = `turn${depth === 1 ? '' : depth}`;
        lines.add(`for (let ${turn} = 1; ${turn} <= ${step.times}; ${turn}++) {`);
        lines.inside(() => this.#body(step.steps, mayStop, depth + 1)).add('}');
      }
      if (step.kind !== 'until') continue;
      const holds = `holds${this.name(`send ${step.request.name}`).slice('send'.length)}`;
      lines.add(`const ${holds} = async () => {`).inside(() => {
        lines.add(`const reply = await ${this.name(`send ${step.request.name}`)}(line);`);
        lines.add(`return reply !== undefined && ${this.name(step.holds)}(reply);`);
      });
      lines.add('};');
      orFail(`waitUntil(${holds}, ${step.interval}, ${step.timeout})`, step.about, step.stops);
    }
  }

  protected override main(): void {
    const { requests, sequence } = this.plan;
    const lines = this.lines;
    const given = `given[0] ?? ${this.isTcp ? 'HOST' : 'PORT'}`;
    this.#define(`export async function main(given)`, 'Does what the command line says; gives the exit code.', () => {
      if (sequence === undefined) this.#offline();
      if (!this.exchanges) return;
      lines.add(`const line = await open(${given});`);
      lines.add('try {').inside(() => {
        if (sequence === undefined) {
          const [only] = requests;
          if (requests.length === 1 && only) {
            lines.add(`return (await ${this.name(`send ${only.name}`)}(line)) === undefined ? 1 : 0;`);
            return;
          }
          lines.add('let good = true;');
          for (const { name } of requests)
            lines.add(`if ((await ${this.name(`send ${name}`)}(line)) === undefined) good = false;`);
          lines.add('return good ? 0 : 1;');
        } else if (sequence.finally.length === 0) lines.add('await steps(line);').add('return 0;');
        else {
          lines.add('try {').inside(() => lines.add('await steps(line);'));
          lines
            .add('} finally {')
            .inside(() => lines.add('await finish(line);'))
            .add('}');
          lines.add('return 0;');
        }
      });
      lines.add('} finally {').inside(() => {
        lines.add(this.isTcp ? 'line.destroy();' : 'await done((next) => line.close(next));');
      });
      lines.add('}');
    });
    lines
      .part()
      .add('if (process.argv[1] === fileURLToPath(import.meta.url)) {')
      .inside(() => {
        const main = 'process.exitCode = await main(process.argv.slice(2))';
        if (!this.exchanges) lines.add(`${main};`);
        else {
          lines
            .add(`${main}.catch((error) => {`)
            .inside(() => lines.add('console.error(error.message);').add('return 1;'));
          lines.add('});');
        }
      });
    lines.add('}');
  }

  /** What the program does without a line. */
  #offline(): void {
    const { requests } = this.plan;
    const lines = this.lines;
    const checked = requests.filter(({ check }) => check !== undefined);
    const print = () => {
      for (const request of requests) lines.add(`console.log(Buffer.from(${this.frame(request)}).toString("hex"));`);
    };
    if (this.checks) {
      lines.add('if (given[0] === "--check") {').inside(() => {
        lines.add('const replies = given.slice(1).map((text) => Buffer.from(text.replaceAll(" ", ""), "hex"));');
        const shows = checked.map(({ name }, at) => `${this.name(`show ${name}`)}(replies[${at}])`);
        lines.add(
          shows.length === 1
            ? `return ${shows[0]} ? 0 : 1;`
            : `return [${shows.join(', ')}].every((good) => good) ? 0 : 1;`,
        );
      });
      lines.add('}');
    }
    if (this.exchanges) {
      lines.add('if (given[0] === "--bytes") {').inside(() => {
        print();
        lines.add('return 0;');
      });
      lines.add('}');
    } else {
      print();
      lines.add('return 0;');
    }
  }
}

export const javascript = scriptTarget(
  { id: 'javascript', name: 'JavaScript (serialport)', language: 'javascript', proof: 'run' },
  Writer,
);
