import type { Transport } from '../../modbus/index.ts';
import type { Name } from '../code.ts';
import { Names } from '../names.ts';
import type { Plan, PlannedRequest, ProgramNote } from '../plan.ts';
import { CodePrinter } from '../print.ts';
import type { Target } from '../target.ts';
import { Lines } from '../written.ts';
import { quoted } from './c-like.ts';
import { javascriptRules } from './javascript-names.ts';
import { partLines } from './javascript-shell.ts';
import { javascriptSyntax, jsdoc } from './javascript-syntax.ts';
import { programAbout, programName } from './shell.ts';

/** A library of JavaScript that carries requests out. */
export interface JavaScriptLibrary {
  readonly id: string;
  readonly name: string;
  readonly transports: readonly Transport[];
  readonly parts: Target['parts'];
  /** What is installed. */
  readonly install: (plan: Plan) => string;
  /** Imports and settings. */
  readonly head: (plan: Plan) => string;
  /** Functions that all requests share. */
  readonly shared: (plan: Plan) => readonly string[];
  /** The constant of a request, as the text of its value; `undefined` if it needs none, or if its bytes are the constant. */
  readonly constant: (request: PlannedRequest, plan: Plan) => string | 'bytes' | undefined;
  /** The lines that carry a request out and return whether it went well; `frame` is its constant. */
  readonly request: (request: PlannedRequest, frame: string, plan: Plan) => string;
  /** What is done before the line is opened, such as `--bytes`; `frames` are the constants. */
  readonly offline: (frames: readonly string[]) => string;
  readonly open: (given: string, plan: Plan) => string;
  readonly close: (plan: Plan) => string;
}

function write(library: JavaScriptLibrary, plan: Plan): ReturnType<Target['write']> {
  const lines = new Lines();
  const notes: ProgramNote[] = [];
  const { comments } = plan.options;
  const names = new Names(javascriptRules, plan.options.names);
  const printer = new CodePrinter(javascriptSyntax(names.of), plan.code, comments);
  const name = (of: Name) => printer.name(of, 'routine');
  const frame = ({ name: of }: PlannedRequest) => printer.name(`${of} frame`, 'table');
  const file = `${programName(plan).replaceAll(' ', '-')}-${library.id}.mjs`;
  const add = (text: string) => {
    if (text.trim() !== '') for (const line of partLines(text, comments)) lines.add(line);
  };
  const server = plan.transport === 'tcp' ? 'HOST' : 'PORT';
  printer.remark(
    lines,
    programAbout(plan),
    `node ${file} [${server}]  carries it out`,
    `It needs ${library.name}: npm install ${library.install(plan)}`,
  );
  lines.add('');
  add(library.head(plan));
  for (const part of library.shared(plan)) {
    lines.part();
    add(part);
  }
  for (const request of plan.requests) {
    const constant = library.constant(request, plan);
    if (constant === undefined) continue;
    lines.part();
    if (constant === 'bytes') {
      notes.push({ code: 'not-offered', what: 'function', request: request.name });
      printer.remark(lines, `${library.name} has no call for this: ${request.about}`);
      const table = { name: `${request.name} frame`, type: 'byte', base: 16, comment: '', rows: request.rows } as const;
      printer.table(lines, { ...table, values: [...request.bytes] });
    } else add(`export const ${frame(request)} = ${constant};`);
  }
  for (const request of plan.requests) {
    lines.part();
    if (comments) for (const line of jsdoc([request.about])) lines.add(line);
    lines.add(`async function ${name(`send ${request.name}`)}(client) {`);
    lines.inside(() => add(library.request(request, frame(request), plan))).add('}');
  }
  lines.part();
  if (comments) lines.add('/** Carries everything out; gives the exit code. */');
  lines.add('export async function main(given) {').inside(() => {
    add(library.offline(plan.requests.map(frame)));
    add(library.open(`given[0] ?? ${server}`, plan));
    lines.add('try {').inside(() => {
      lines.add('let good = true;');
      for (const request of plan.requests)
        lines.add(`if (!(await ${name(`send ${request.name}`)}(client))) good = false;`);
      lines.add('return good ? 0 : 1;');
    });
    lines
      .add('} finally {')
      .inside(() => add(library.close(plan)))
      .add('}');
  });
  lines.add('}');
  lines
    .part()
    .add('if (process.argv[1] === fileURLToPath(import.meta.url)) {')
    .inside(() => {
      lines.add('process.exitCode = await main(process.argv.slice(2)).catch((error) => {');
      lines.inside(() => lines.add('console.error(error.message);').add('return 1;')).add('});');
    });
  return { files: [lines.add('}').file(file)], notes: [...names.notes, ...notes] };
}

export const javascriptLibrary = (library: JavaScriptLibrary): Target => ({
  id: library.id,
  name: library.name,
  language: 'javascript',
  proof: 'run',
  parts: library.parts,
  transports: library.transports,
  sequences: false,
  write: (plan) => write(library, plan),
});

/** The line of a settings object of serialport. */
export const serialSettings = ({ options: { line } }: Plan): string =>
  `{ baudRate: ${line.baud}, dataBits: ${line.dataBits}, parity: "${line.parity}", stopBits: ${line.stopBits} }`;

/** Where the line or the server is. */
export const wherePart = ({ transport, options: { line, server } }: Plan): string =>
  transport === 'tcp'
    ? `const HOST = ${quoted(server.host)};\nconst PORT = ${server.port};`
    : `const PORT = ${quoted(line.port)};`;
