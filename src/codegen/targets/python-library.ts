import type { Transport } from '../../modbus/index.ts';
import type { Name } from '../code.ts';
import { Names } from '../names.ts';
import type { Plan, PlannedRequest, ProgramNote } from '../plan.ts';
import { CodePrinter, plainText } from '../print.ts';
import type { Target } from '../target.ts';
import { Lines } from '../written.ts';
import { type Call, callFor, callText, numbersOf } from './calls.ts';
import { pythonRules } from './python-names.ts';
import { docstring, pythonSyntax, pythonText } from './python-syntax.ts';
import { programAbout, programName } from './shell.ts';

const STEP = '    ';
const EMPTY_LINES = 2;

/** A call with its values, what of the answer is printed, and the text that says what it is. */
export interface CalledRequest {
  readonly call: string;
  readonly gives: string | undefined;
  readonly about: string;
}

/** A library of Python that sends requests by a call each. */
export interface PythonLibrary {
  readonly id: string;
  readonly name: string;
  readonly transports: readonly Transport[];
  readonly calls: readonly Call[];
  /** What is installed: `minimalmodbus`. */
  readonly install: string;
  /** The type and the name of what requests are sent by. */
  readonly client: (plan: Plan) => { readonly type: string; readonly name: string };
  /** Imports and settings. */
  readonly head: (plan: Plan) => string;
  /** Bits as a list of truths, or of 0 and 1. */
  readonly truths: boolean;
  /** The lines of a request that is carried out by a call; they return whether it went well. */
  readonly called: (call: CalledRequest, request: PlannedRequest, plan: Plan) => string;
  /** The lines that send a constant frame and print what comes back. */
  readonly raw: (frame: string, about: string, plan: Plan) => string;
  /** What opens the client, and the exceptions that say that it did not go well. */
  readonly open: (given: string, plan: Plan) => string;
  readonly errors: string;
}

/** A number, a truth, a list or bytes as Python writes them. */
const valueWriter =
  (truths: boolean) =>
  (value: unknown, field: string): string => {
    if (typeof value === 'boolean') return truths ? (value ? 'True' : 'False') : String(Number(value));
    if (typeof value === 'string') return `bytes.fromhex("${value}")`;
    if (!Array.isArray(value)) return String(value);
    if (field !== 'bits' || !truths) return `[${numbersOf(value).join(', ')}]`;
    return `[${numbersOf(value)
      .map((bit) => (bit === 0 ? 'False' : 'True'))
      .join(', ')}]`;
  };

function write(library: PythonLibrary, plan: Plan): ReturnType<Target['write']> {
  const lines = new Lines(STEP, EMPTY_LINES);
  const notes: ProgramNote[] = [];
  const { comments } = plan.options;
  const names = new Names(pythonRules, plan.options.names);
  const printer = new CodePrinter(pythonSyntax(names.of), plan.code, comments);
  const name = (of: Name) => printer.name(of, 'routine');
  const { name: client, type } = library.client(plan);
  const file = `${programName(plan).replaceAll(' ', '_')}_${library.id}.py`;
  const add = (text: string) => {
    for (const line of text.split('\n')) if (line !== '' && (comments || !line.trim().startsWith('#'))) lines.add(line);
  };
  if (comments) {
    const server = plan.transport === 'tcp' ? 'HOST' : 'PORT';
    const usage = [
      `python3 ${file} [${server}]  carries it out`,
      `It needs ${library.name}: pip install "${library.install}"`,
    ];
    for (const line of docstring([programAbout(plan)], usage)) lines.add(line);
    lines.add('');
  }
  for (const line of library.head(plan).trim().split('\n')) lines.add(line);
  const frame = (request: PlannedRequest) => printer.name(`${request.name} frame`, 'table');
  const body = (request: PlannedRequest) => {
    const about = `${request.about}:`;
    const call = callFor(library.calls, request);
    if (call === undefined) return library.raw(frame(request), pythonText(about), plan);
    const text = callText(call, request, valueWriter(library.truths));
    const gives = call.gives?.replace('{quantity}', String(request.reading.fields['quantity']));
    return library.called({ call: text, gives, about: pythonText(about) }, request, plan);
  };
  for (const request of plan.requests) {
    if (callFor(library.calls, request) !== undefined) continue;
    notes.push({ code: 'not-offered', what: 'function', request: request.name });
    lines.part();
    if (comments) lines.add(`# ${library.name} has no call for this: ${plainText(request.about)}`);
    printer.table(lines, {
      name: `${request.name} frame`,
      type: 'byte',
      values: [...request.bytes],
      base: 16,
      comment: '',
      rows: request.rows,
    });
  }
  for (const request of plan.requests) {
    lines.part().add(`def ${name(`send ${request.name}`)}(${client}: ${type}) -> bool:`);
    lines.inside(() => {
      if (comments) for (const line of docstring([request.about])) lines.add(line);
      add(body(request));
    });
  }
  lines
    .part()
    .add('def main(arguments: list[str]) -> int:')
    .inside(() => {
      if (comments) lines.add('"""Carries everything out; gives the exit code."""');
      const given = `arguments[0] if arguments else ${plan.transport === 'tcp' ? 'HOST' : 'PORT'}`;
      lines.add('try:').inside(() => {
        add(library.open(given, plan));
        lines.inside(() => {
          const sent = plan.requests.map((request) => `${name(`send ${request.name}`)}(${client})`);
          if (sent.length === 1) lines.add(`return 0 if ${sent[0]} else 1`);
          else {
            lines.add('good = [').inside(() => {
              for (const one of sent) lines.add(`${one},`);
            });
            lines.add(']').add('return 0 if all(good) else 1');
          }
        });
      });
      lines.add(`except ${library.errors} as error:`).inside(() => {
        lines.add('print(error, file=sys.stderr)').add('return 1');
      });
    });
  lines
    .part()
    .add('if __name__ == "__main__":')
    .inside(() => lines.add('sys.exit(main(sys.argv[1:]))'));
  return { files: [lines.file(file)], notes: [...names.notes, ...notes] };
}

export const pythonLibrary = (library: PythonLibrary): Target => ({
  id: library.id,
  name: library.name,
  language: 'python',
  proof: 'run',
  parts: ['exchange'],
  transports: library.transports,
  sequences: false,
  write: (plan) => write(library, plan),
});
