import type { Name, Routine, Scalar, Texts } from '../../code.ts';
import { Names } from '../../names.ts';
import type { Plan } from '../../plan.ts';
import { CodePrinter } from '../../print.ts';
import type { Target } from '../../target.ts';
import { Lines } from '../../written.ts';
import { holdsFrame } from '../iec/dialect.ts';
import { FRAME, lowered, RESULT } from '../iec/lower.ts';
import { frameCapacity, stringLiteral } from '../iec/units.ts';
import { Hoist, type Tags } from './hoist.ts';
import { Raws, rockwellNames, rockwellSyntax, typeOf } from './rockwell-syntax.ts';

/** Rockwell Studio 5000: routines in Structured Text, and the tags that they use. */
export const rockwell: Target = {
  id: 'rockwell',
  name: 'Rockwell Studio 5000 (Structured Text)',
  language: 'iecst',
  proof: 'rules',
  parts: ['bytes', 'build', 'check'],
  transports: ['rtu', 'ascii', 'tcp', 'pdu'],
  sequences: false,
  write: (plan) => new Rockwell(plan).write(),
};

interface Tag {
  readonly type: string;
  readonly about: string;
}

class Rockwell {
  readonly #plan: Plan;
  readonly #names: Names;
  readonly #raws = new Raws();
  readonly #tags = new Map<string, Tag>();
  readonly #lines = new Lines('    ');
  readonly #printer: CodePrinter;
  #routine: Name = '';
  #spares = 0;

  constructor(plan: Plan) {
    this.#plan = plan;
    this.#names = new Names(rockwellNames, plan.options.names);
    const syntax = rockwellSyntax((name) => this.#tagOf(name), this.#raws);
    this.#printer = new CodePrinter(syntax, plan.code, plan.options.comments);
  }

  write(): ReturnType<Target['write']> {
    const { code, requests } = this.#plan;
    const texts = this.#lines;
    this.#printer.remark(
      texts,
      ...requests.map(({ about }) => about),
      'Each part below is a routine of its own, in Structured Text. Its tags are in tags.csv, which Studio 5000 imports.',
      'A call sets the tags of a routine, jumps to it by JSR, and takes its result. Bytes are DINT from 0 to 255.',
    );
    this.#constants();
    for (const one of code.texts) this.#texts(one);
    for (const one of code.routines) this.#write(one);
    for (const one of requests) if (one.build === undefined) this.#frame(one);
    return { files: [texts.file('modbus-routines.st'), this.#list()], notes: this.#names.notes };
  }

  /** The tag of a name in the routine that is written: constants and tables are shared. */
  #tagOf(name: Name): string {
    const { constants, tables } = this.#plan.code;
    if (name === RESULT) return this.#result(this.#routine);
    if (constants.some((one) => one.name === name)) return this.#names.of(name, 'constant');
    if (tables.some((one) => one.name === name)) return this.#names.of(name, 'table');
    return this.#variable(this.#routine, name);
  }

  #variable(routine: Name, name: Name): string {
    return this.#names.of(`${routine} ${name}`, 'variable');
  }

  #result(routine: Name): string {
    return this.#variable(routine, 'result');
  }

  #declare(tag: string, type: Scalar, size: number | undefined, about: string): void {
    this.#tags.set(tag, { type: typeOf(type) + (size === undefined ? '' : `[${size}]`), about });
  }

  #size(routine: Name, parameter: Name): number {
    const found = this.#plan.code.routines
      .find(({ name }) => name === routine)
      ?.parameters.find(({ name }) => name === parameter);
    if (found === undefined) return frameCapacity(this.#plan);
    return holdsFrame(found) ? frameCapacity(this.#plan) : (found.size ?? 1);
  }

  #head(name: Name, about: readonly string[]): void {
    this.#routine = name;
    this.#lines.add('');
    this.#lines.add(`// ---- routine ${this.#names.of(name, 'routine')}`);
    this.#printer.remark(this.#lines, ...about);
  }

  #write(routine: Routine): void {
    const { code } = this.#plan;
    this.#head(routine.name, routine.about);
    const low = lowered(routine, code);
    for (const one of routine.parameters)
      this.#declare(
        this.#tagOf(one.name),
        one.type,
        one.size === undefined ? undefined : this.#size(routine.name, one.name),
        one.comment,
      );
    for (const { name, type } of low.locals) this.#declare(this.#tagOf(name), type, undefined, '');
    const gives = routine.gives.kind === 'frame' ? 'int' : routine.gives.type;
    this.#declare(this.#result(routine.name), gives, undefined, 'what the routine gives');
    if (routine.gives.kind === 'frame')
      this.#declare(this.#tagOf(FRAME), 'byte', frameCapacity(this.#plan), 'the bytes of the frame');
    const tags: Tags = {
      of: (of, variable) => this.#variable(of, variable),
      result: (of) => this.#result(of),
      routine: (of) => this.#names.of(of, 'routine'),
      size: (of, parameter) => this.#size(of, parameter),
      spare: (type) => {
        const name = `value ${++this.#spares}`;
        this.#declare(this.#variable(routine.name, name), type, undefined, '');
        return name;
      },
    };
    const hoist = new Hoist(code, routine, tags, this.#raws, (expression) => this.#printer.slot(expression));
    this.#printer.statements(this.#lines, hoist.statements(low.body));
  }

  #frame({ bytes, rows, about, table, name }: Plan['requests'][number]): void {
    const routine = table ?? name;
    this.#head(routine, [about]);
    const frame = this.#tagOf(FRAME);
    this.#declare(frame, 'byte', frameCapacity(this.#plan), 'the bytes of the frame');
    this.#declare(this.#result(routine), 'int', undefined, 'how many bytes');
    this.#printer.aligned(
      this.#lines,
      rows.flatMap(({ from, to, span, comment }) =>
        Array.from({ length: to - from }, (_, index) => ({
          text: `${frame}[${from + index}] := ${this.#printer.print({ kind: 'number', type: 'byte', value: bytes[from + index] ?? 0, base: 16 }).text};`,
          comment: index === 0 ? comment : undefined,
          spans: [span],
        })),
      ),
    );
    this.#lines.add(`${this.#result(routine)} := ${bytes.length};`);
  }

  #texts({ name, about, parameter, entries, otherwise }: Texts): void {
    this.#head(name, [about]);
    const [of, result] = [this.#tagOf(parameter), this.#result(name)];
    this.#declare(of, 'int', undefined, '');
    this.#tags.set(result, { type: 'STRING', about: 'the text' });
    this.#lines.add(`CASE ${of} OF`).inside(() => {
      for (const { number, text } of entries) this.#lines.add(`${number}: ${result} := ${stringLiteral(text)};`);
    });
    this.#lines.add('ELSE').inside(() => this.#lines.add(`${result} := ${stringLiteral(otherwise)};`));
    this.#lines.add('END_CASE;');
  }

  /** Tags have no first values in a list that is imported: one routine sets constants and tables, at the first scan. */
  #constants(): void {
    const { constants, tables } = this.#plan.code;
    const plain = tables.filter(({ rows }) => rows === undefined);
    if (constants.length + plain.length === 0) return;
    this.#head('modbus setup', ['Constants: call it once, when S:FS is on.']);
    for (const { name, type, value, comment } of constants) {
      this.#declare(this.#tagOf(name), type, undefined, comment);
      this.#lines.add(`${this.#tagOf(name)} := ${value};`);
    }
    for (const { name, type, values, comment } of plain) {
      this.#declare(this.#tagOf(name), type, values.length, comment);
      for (const [index, value] of values.entries()) this.#lines.add(`${this.#tagOf(name)}[${index}] := ${value};`);
    }
  }

  #list() {
    const lines = new Lines('').add('TYPE,SCOPE,NAME,DESCRIPTION,DATATYPE,SPECIFIER,ATTRIBUTES');
    const quoted = (text: string) => `"${text.replace(/["$']/g, '')}"`;
    for (const [name, { type, about }] of this.#tags)
      lines.add(`TAG,,${name},${quoted(this.#plan.options.comments ? about : '')},"${type}","",""`);
    return lines.file('tags.csv');
  }
}
