import { MOST_ASCII, MOST_PDU, MOST_RTU, MOST_TCP } from '../../../modbus/index.ts';
import { latinLetters } from '../../../notation/index.ts';
import type { Code, Expression, Name, Parameter, Routine, Scalar, Table, Texts } from '../../code.ts';
import type { NameKind } from '../../names.ts';
import type { Plan, PlannedRequest } from '../../plan.ts';
import { CodePrinter } from '../../print.ts';
import type { Remarked } from '../../syntax.ts';
import type { Lines } from '../../written.ts';
import { byReference, type Dialect, holdsFrame } from './dialect.ts';
import { iecSyntax } from './iec-syntax.ts';
import { FRAME, lowered } from './lower.ts';

export type SectionKind = 'VAR_INPUT' | 'VAR_IN_OUT' | 'VAR_OUTPUT' | 'VAR' | 'VAR_TEMP' | 'VAR CONSTANT';

/** A declaration; `value` is what it holds at first. */
export interface Variable {
  readonly name: Name;
  readonly role?: NameKind;
  readonly type: string;
  readonly value?: string | undefined;
  readonly comment?: string | undefined;
}
export interface Section {
  readonly kind: SectionKind;
  readonly variables: readonly Variable[];
}

/** What the types of arrays are called by their elements. */
const PLURALS: Readonly<Record<Scalar, Name>> = {
  byte: 'bytes',
  word: 'words',
  dword: 'dwords',
  int: 'dints',
  bool: 'bools',
  real: 'lreals',
};

/** How many bytes an array has that holds any frame, and in front of it the request that an adapter gives back. */
export function frameCapacity({ transport, options }: Plan): number {
  const most = { rtu: MOST_RTU, ascii: MOST_ASCII, tcp: MOST_TCP, pdu: MOST_PDU }[transport];
  return options.echo && transport !== 'tcp' ? 2 * most : most;
}

/** Writes functions and function blocks in a language of the family. */
export class Units {
  readonly dialect: Dialect;
  readonly code: Code;
  readonly lines: Lines;
  readonly printer: CodePrinter;
  readonly #begin: (routine: Routine) => void;
  /** How long an array is that holds a frame. */
  readonly frameSize: number;

  constructor(dialect: Dialect, code: Code, lines: Lines, comments: boolean, frameSize: number) {
    this.dialect = dialect;
    this.code = code;
    this.lines = lines;
    this.frameSize = frameSize;
    const { syntax, begin } = iecSyntax(dialect, code);
    this.#begin = begin;
    this.printer = new CodePrinter(syntax, code, comments);
  }

  get frameType(): string {
    return this.dialect.array('byte', this.frameSize, 'modbus frame');
  }

  value(type: Scalar, value: number): string {
    if (type === 'bool') return value === 0 ? 'FALSE' : 'TRUE';
    const base = type === 'byte' || type === 'word' || type === 'dword' ? 16 : 10;
    return this.printer.syntax.number({ kind: 'number', type, value, base });
  }

  typeOf(parameter: Pick<Parameter, 'type' | 'size' | 'filled'>): string {
    const { type, size } = parameter;
    if (size === undefined) return this.dialect.types[type];
    return holdsFrame(parameter) ? this.frameType : this.dialect.array(type, size, `${PLURALS[type]} ${size}`);
  }

  routine(routine: Routine): void {
    const { printer, lines, dialect } = this;
    const low = lowered(routine, this.code);
    const { gives } = routine;
    const parameters = [...routine.parameters];
    if (gives.kind === 'frame')
      parameters.push({ name: FRAME, type: 'byte', size: this.frameSize, filled: true, comment: 'takes the bytes' });
    const variables = (of: readonly Parameter[]) =>
      of.map((one): Variable => {
        const type = one.name === FRAME && one.filled ? this.frameType : this.typeOf(one);
        return { name: one.name, type, comment: one.comment };
      });
    const locals = low.locals.map(({ name, type }): Variable => ({ name, type: dialect.types[type] }));
    this.about(gives.kind === 'frame' ? [...routine.about, 'Gives the number of bytes.'] : routine.about);
    this.unit(
      'FUNCTION',
      routine.name,
      dialect.types[gives.kind === 'frame' ? 'int' : gives.type],
      [
        { kind: 'VAR_INPUT', variables: variables(parameters.filter((one) => !byReference(one))) },
        { kind: 'VAR_IN_OUT', variables: variables(parameters.filter(byReference)) },
        { kind: dialect.locals, variables: locals },
        { kind: 'VAR CONSTANT', variables: low.constants.map((one) => this.constant(one.name)) },
      ],
      dialect.table === undefined ? low.tables : [],
      () => {
        this.#begin(routine);
        printer.statements(lines, low.body);
      },
    );
  }

  constant(of: Name): Variable {
    const found = this.code.constants.find(({ name }) => name === of);
    if (!found) throw new TypeError(`no constant ${of}`);
    const value = this.printer.syntax.number({ ...found, kind: 'number' });
    return { name: of, role: 'constant', type: this.dialect.types[found.type], value, comment: found.comment };
  }

  /** The bytes of a request that has nothing to fill in. */
  frame(request: PlannedRequest, routine: Name): void {
    const { lines, printer, dialect } = this;
    this.about([`The bytes of: ${request.about}`, 'Gives their number.']);
    this.unit(
      'FUNCTION',
      routine,
      dialect.types.int,
      [{ kind: 'VAR_IN_OUT', variables: [{ name: FRAME, type: this.frameType, comment: 'takes the bytes' }] }],
      [],
      () => {
        const frame = dialect.used(FRAME, 'variable');
        const byte = (at: number) => this.value('byte', request.bytes[at] ?? 0);
        printer.aligned(
          lines,
          request.rows.flatMap(({ from, to, span, comment }) =>
            Array.from({ length: to - from }, (_, index) => ({
              text: `${frame}[${from + index}] := ${byte(from + index)};`,
              comment: index === 0 ? comment : undefined,
              spans: [span],
            })),
          ),
        );
        lines.add(`${dialect.result(routine)} := ${request.bytes.length};`);
      },
    );
  }

  texts({ name, about, parameter, entries, otherwise }: Texts): void {
    const { lines, dialect } = this;
    const result = dialect.result(name);
    const give = (text: string) => `${result} := ${stringLiteral(text)};`;
    this.about([about]);
    this.unit(
      'FUNCTION',
      name,
      dialect.string,
      [{ kind: 'VAR_INPUT', variables: [{ name: parameter, type: dialect.types.int }] }],
      [],
      () => {
        lines.add(`CASE ${dialect.used(parameter, 'variable')} OF`).inside(() => {
          for (const { number, text } of entries) lines.add(`${number}: ${give(text)}`);
        });
        lines.add('ELSE').inside(() => lines.add(give(otherwise)));
        lines.add('END_CASE;');
      },
    );
  }

  about(texts: readonly string[]): void {
    this.lines.add('');
    this.printer.remark(this.lines, ...texts);
  }

  /** A function or function block with its variables. */
  unit(
    kind: 'FUNCTION' | 'FUNCTION_BLOCK',
    name: Name,
    gives: string | undefined,
    sections: readonly Section[],
    tables: readonly Table[],
    body: () => void,
  ): void {
    const { lines, dialect } = this;
    const role = kind === 'FUNCTION' ? 'routine' : 'type';
    for (const line of dialect.head(kind, dialect.declared(name, role), gives)) lines.add(line);
    for (const section of sections) this.#section(section);
    for (const table of tables) {
      lines.add('VAR CONSTANT').inside(() => this.printer.table(lines, table));
      lines.add('END_VAR');
    }
    lines.add(dialect.begin);
    body();
    lines.add(`END_${kind}`);
  }

  #section({ kind, variables }: Section): void {
    if (variables.length === 0) return;
    const { lines, dialect, printer } = this;
    lines.add(kind).inside(() =>
      printer.aligned(
        lines,
        variables.map(({ name, role = 'variable', type, value, comment }): Remarked => {
          const first = value === undefined || (value.startsWith('[') && !dialect.arrayValues) ? '' : ` := ${value}`;
          return { text: `${dialect.declared(name, role)} : ${type}${first};`, comment };
        }),
      ),
    );
    lines.add('END_VAR');
  }

  /** A call of a routine with its parameters by name. */
  call(routine: Name, ...given: readonly (readonly [parameter: Name, value: string])[]): string {
    const list = given.map(([name, value]) => `${this.dialect.declared(name, 'variable')} := ${value}`);
    return `${this.dialect.used(routine, 'routine')}(${list.join(', ')})`;
  }

  /** The parameters of a routine, in their order. */
  parametersOf(routine: Name): readonly Parameter[] {
    return this.code.routines.find(({ name }) => name === routine)?.parameters ?? [];
  }

  print(expression: Expression): string {
    return this.printer.slot(expression);
  }
}

/** A text of one line in quotes, in which `$` marks what is special (IEC 61131-3, 6.3.3). Only ASCII, as a STRING has bytes. */
export const stringLiteral = (text: string): string =>
  `'${latinLetters(text)
    .replace(/[^\x20-\x7e]/gu, '?')
    .replace(/[$']/g, '$$$&')}'`;
