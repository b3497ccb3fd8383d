import type { Name, Scalar } from '../code.ts';
import type { BuildArgument, Plan, PlannedRequest, PlannedStep } from '../plan.ts';
import { Lines } from '../written.ts';
import { pythonRules } from './python-names.ts';
import { exchangeParts, FAILED, partLines, VERDICT, WAIT_UNTIL } from './python-shell.ts';
import { docstring, pythonSyntax, pythonText } from './python-syntax.ts';
import { ScriptWriter, scriptTarget } from './scripted.ts';
import { argumentTexts, isAnswered, itemsCall, pauseOf, programAbout, programName, SILENCE, uses } from './shell.ts';

const STEP = '    ';
/** Between functions and classes. */
const EMPTY_LINES = 2;

const seconds = (milliseconds: number): string => String(milliseconds / 1000);

/** Writes the program of one plan. */
class Writer extends ScriptWriter {
  constructor(plan: Plan) {
    super(
      {
        rules: pythonRules,
        syntax: pythonSyntax,
        lines: () => new Lines(STEP, EMPTY_LINES),
        fileName: (of) => `${programName(of).replaceAll(' ', '_')}.py`,
        partLines,
        verdict: VERDICT,
        exchangeParts,
        waitUntil: WAIT_UNTIL,
        sequence: FAILED,
      },
      plan,
    );
  }

  /** A function of the shell. */
  #define(head: string, about: string, body: () => void): void {
    this.lines.part().add(`def ${head}:`);
    this.lines.inside(() => {
      if (this.plan.options.comments) for (const line of docstring([about])) this.lines.add(line);
      body();
    });
  }

  protected override head(name: string): void {
    const { options, code, sequence } = this.plan;
    const lines = this.lines;
    if (options.comments) {
      const about = [programAbout(this.plan)];
      if (this.exchanges) about.push(`python3 ${name} [${this.isTcp ? 'HOST' : 'PORT'}]  carries it out`);
      if (sequence === undefined) about.push(`python3 ${name} --bytes  prints what is sent`);
      if (sequence === undefined && this.checks) about.push(`python3 ${name} --check HEX  checks a reply`);
      if (this.exchanges && !this.isTcp) about.push('It needs pyserial: pip install pyserial');
      for (const line of docstring(about.slice(0, 1), about.slice(1))) lines.add(line);
      lines.add('');
    }
    const modules = [
      ...(uses(code, 'floor') ? ['math'] : []),
      ...(this.exchanges && this.isTcp ? ['socket'] : []),
      ...(uses(code, 'float') ? ['struct'] : []),
      'sys',
      ...(this.exchanges ? ['time'] : []),
    ];
    for (const module of modules) lines.add(`import ${module}`);
    if (!this.exchanges) return;
    if (this.answered) lines.add('from collections.abc import Callable');
    if (!this.isTcp) lines.text('\nimport serial');
    lines.add('');
    this.printer.aligned(lines, [
      ...this.#line(),
      {
        text: `TIMEOUT = ${seconds(options.timeout)}`,
        comment: 'seconds from the end of the request to the whole reply',
      },
    ]);
  }

  /** The settings of the line. */
  #line() {
    const { options } = this.plan;
    const { host, port: tcpPort } = options.server;
    if (this.isTcp) return [{ text: `HOST = ${pythonText(host)}` }, { text: `PORT = ${tcpPort}` }];
    const { port, baud, dataBits, parity, stopBits } = options.line;
    return [
      { text: `PORT = ${pythonText(port)}` },
      { text: `BAUD = ${baud}` },
      { text: `DATA_BITS = ${dataBits}` },
      { text: `PARITY = serial.PARITY_${parity.toUpperCase()}` },
      { text: `STOP_BITS = ${stopBits}` },
      { text: `PAUSE = ${seconds(pauseOf(options))}`, comment: 'seconds of silence between two frames' },
      { text: `SILENCE = ${seconds(SILENCE)}`, comment: 'seconds of silence that end a reply of unknown length' },
    ];
  }

  #given(argument: BuildArgument): string {
    const { type, name } = argument.parameter;
    const plain = (value: number, of: Scalar): string => {
      if (of === 'bool') return value === 0 ? 'False' : 'True';
      return this.printer.syntax.number({ kind: 'number', type: of, value, base: 10 });
    };
    const texts = argumentTexts(
      argument,
      (value) => plain(value, type),
      ({ routine, value }) => `${this.name(routine)}(${plain(value, 'real')})`,
    );
    const list = typeof argument.value === 'number' ? texts.join('') : `[${texts.join(', ')}]`;
    const given = typeof argument.value !== 'number' && type === 'byte' ? `bytes(${list})` : list;
    return `${this.printer.name(name)}=${given}`;
  }

  protected override built(constant: string, routine: Name, given: readonly BuildArgument[]): void {
    const counted = given.filter(({ parameter }) => parameter.lengthOf === undefined);
    this.lines.add(`${constant} = ${this.name(routine)}(${counted.map((one) => this.#given(one)).join(', ')})`);
  }

  /** What checks the reply and prints what it says, and what carries the request out. */
  protected override request(request: PlannedRequest): void {
    const { name, about, check, wanted, list } = request;
    const lines = this.lines;
    const line = this.isTcp ? 'line: socket.socket' : 'line: serial.Serial';
    const send = this.name(`send ${name}`);
    if (this.checks && check !== undefined) {
      this.#define(
        `${this.name(`show ${name}`)}(reply: bytes) -> bool`,
        'Prints what a reply says; gives whether it is good.',
        () => {
          if (list?.size !== undefined) lines.add(`values = [${list.type === 'bool' ? 'False' : '0'}] * ${list.size}`);
          lines.add(`result = ${this.name(check)}(${this.frame(request)}, reply${list ? ', values' : ''})`);
          lines.add(`print(${pythonText(`${about}:`)}, verdict(result))`);
          this.#values(request);
          lines.add('return result == 0');
        },
      );
    }
    if (!this.exchanges) return;
    if (check !== undefined && wanted !== undefined) {
      this.#define(`${send}(${line}) -> bytes | None`, `${about}. Gives the reply, if it is good.`, () => {
        lines.add(`reply = exchange(line, ${this.frame(request)}, ${this.name(wanted)})`);
        lines.add(`return reply if ${this.name(`show ${name}`)}(reply) else None`);
      });
    } else {
      this.#define(`${send}(${line}) -> bytes | None`, `${about}. No reply comes.`, () => {
        lines.add(`send(line, ${this.frame(request)})`).add('return b""');
      });
    }
  }

  #values(request: PlannedRequest): void {
    const { values, list } = request;
    const items = itemsCall(request, (routine) => this.name(routine), 'len(reply)', true);
    if (values.length === 0 && list === undefined) return;
    const lines = this.lines;
    lines.add('if result == 0:').inside(() => {
      for (const { name, routine, unit } of values) {
        const parts = [
          pythonText(`${name} =`),
          `${this.name(routine)}(reply)`,
          ...(unit === '' ? [] : [pythonText(unit)]),
        ];
        lines.add(`print(${parts.join(', ')})`);
      }
      if (list !== undefined)
        lines.add(`print(${pythonText(`${list.name}:`)}, *values${items === undefined ? '' : `[:${items}]`})`);
    });
  }

  protected override steps(name: 'steps' | 'finish', about: string, steps: readonly PlannedStep[]): void {
    if (steps.length === 0) return;
    this.#define(`${name}(line: ${this.isTcp ? 'socket.socket' : 'serial.Serial'}) -> None`, about, () =>
      this.#body(steps, name === 'steps'),
    );
  }

  #body(steps: readonly PlannedStep[], mayStop: boolean): void {
    const lines = this.lines;
    const orFail = (call: string, about: string, stops: boolean) => {
      if (!stops || !mayStop) lines.add(call);
      else lines.add(`if not ${call}:`).inside(() => lines.add(`raise Failed(${pythonText(about)})`));
    };
    for (const step of steps) {
      this.printer.remark(lines, step.about);
      if (step.kind === 'wait') lines.add(`time.sleep(${seconds(step.duration)})`);
      if (step.kind === 'send') {
        const call = `${this.name(`send ${step.request.name}`)}(line)`;
        if (isAnswered(step.request)) orFail(call, step.about, step.stops);
        else lines.add(call);
      }
      if (step.kind === 'repeat') {
        lines.add(`for _ in range(${step.times}):`);
        lines.inside(() => this.#body(step.steps, mayStop));
      }
      if (step.kind !== 'until') continue;
      const read = `(reply := ${this.name(`send ${step.request.name}`)}(line)) is not None`;
      const condition = `lambda: ${read} and ${this.name(step.holds)}(reply)`;
      orFail(`wait_until(${condition}, ${seconds(step.interval)}, ${seconds(step.timeout)})`, step.about, step.stops);
    }
    if (steps.length === 0) lines.add('pass');
  }

  protected override main(): void {
    const { requests, sequence } = this.plan;
    const lines = this.lines;
    this.#define('main(arguments: list[str]) -> int', 'Does what the command line says; gives the exit code.', () => {
      if (sequence === undefined) this.#offline();
      if (!this.exchanges) return;
      const given = `arguments[0] if arguments else ${this.isTcp ? 'HOST' : 'PORT'}`;
      const open = this.isTcp
        ? `socket.create_connection((${given}, PORT), TIMEOUT)`
        : `serial.Serial(${given}, BAUD, DATA_BITS, PARITY, STOP_BITS)`;
      lines.add('try:').inside(() => {
        lines.add(`with ${open} as line:`).inside(() => {
          if (sequence === undefined) {
            const calls = requests.map(({ name }) => `${this.name(`send ${name}`)}(line)`);
            if (calls.length === 1) lines.add(`return 0 if ${calls[0]} is not None else 1`);
            else {
              lines.add('replies = [').inside(() => this.#items(calls));
              lines.add(']').add('return 1 if None in replies else 0');
            }
          } else this.#run(sequence.finally.length > 0);
        });
      });
      lines.add(sequence === undefined ? 'except OSError as error:' : 'except (Failed, OSError) as error:');
      lines.inside(() => lines.add('print(error, file=sys.stderr)').add('return 1'));
    });
    lines
      .part()
      .add('if __name__ == "__main__":')
      .inside(() => lines.add('sys.exit(main(sys.argv[1:]))'));
  }

  #items(texts: readonly string[]): void {
    for (const text of texts) this.lines.add(`${text},`);
  }

  #run(finishes: boolean): void {
    const lines = this.lines;
    if (!finishes) lines.add('steps(line)');
    else {
      lines.add('try:').inside(() => lines.add('steps(line)'));
      lines.add('finally:').inside(() => lines.add('finish(line)'));
    }
    lines.add('return 0');
  }

  /** What the program does without a line. */
  #offline(): void {
    const { requests } = this.plan;
    const lines = this.lines;
    const checked = requests.filter(({ check }) => check !== undefined);
    const print = () => {
      for (const request of requests) lines.add(`print(${this.frame(request)}.hex(" "))`);
    };
    if (this.checks) {
      const shows = checked.map(
        (request, at) => `${this.name(`show ${request.name}`)}(bytes.fromhex(arguments[${at + 1}]))`,
      );
      lines.add(`if arguments[:1] == ["--check"] and len(arguments) == ${checked.length + 1}:`).inside(() => {
        if (shows.length === 1) lines.add(`return 0 if ${shows[0]} else 1`);
        else {
          lines.add('good = [').inside(() => this.#items(shows));
          lines.add(']').add('return 0 if all(good) else 1');
        }
      });
    }
    if (this.exchanges) {
      lines.add('if arguments[:1] == ["--bytes"]:').inside(() => {
        print();
        lines.add('return 0');
      });
    } else {
      print();
      lines.add('return 0');
    }
  }
}

export const python = scriptTarget(
  { id: 'python', name: 'Python (pyserial)', language: 'python', proof: 'run' },
  Writer,
);
