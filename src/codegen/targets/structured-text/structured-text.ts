import type { Scalar } from '../../code.ts';
import { Names } from '../../names.ts';
import type { Plan } from '../../plan.ts';
import { plainText } from '../../print.ts';
import type { Target } from '../../target.ts';
import { Lines, type WrittenFile } from '../../written.ts';
import { Exchanges, frameRoutine } from '../iec/block.ts';
import type { Dialect } from '../iec/dialect.ts';
import { Uses } from '../iec/lower.ts';
import { requestBlock } from '../iec/request-block.ts';
import { sequenceBlock } from '../iec/sequence-block.ts';
import { frameCapacity, Units } from '../iec/units.ts';
import { iecNames } from '../iec/words.ts';
import { LONGEST_FILE_NAME } from '../shell.ts';
import { helpers } from './helpers.ts';
import { wiring } from './wiring.ts';

const INDENT = '    ';
const TYPES: Readonly<Record<Scalar, string>> = {
  byte: 'BYTE',
  word: 'WORD',
  dword: 'DWORD',
  int: 'DINT',
  bool: 'BOOL',
  real: 'LREAL',
};
/** Comments of OpenPLC's compiler begin with `(*` only, and none stands in another. */
export const comment = (text: string): string =>
  `(* ${plainText(text).replace(/\(\*/g, '( *').replace(/\*\)/g, '* )')} *)`;

function dialect(names: Names, arrays: Map<string, string>): Dialect {
  return {
    types: TYPES,
    conversions: (type) => TYPES[type],
    timer: 'TON',
    string: 'STRING',
    time: 'TIME',
    declared: names.of,
    used: names.of,
    result: (name) => names.of(name, 'routine'),
    comment,
    shift: (way, value, by) => `${way}(${value}, ${by})`,
    float: (bits) => `FC_RealOfBits(Bits := ${bits})`,
    floor: (of) => `FC_Floor(Number := ${of})`,
    array: (type, size, name) => {
      const called = `T_${pascal(name)}`;
      arrays.set(called, `ARRAY[0..${size - 1}] OF ${TYPES[type]}`);
      return called;
    },
    arrayValues: true,
    table: undefined,
    head: (kind, name, gives) => [gives === undefined ? `${kind} ${name}` : `${kind} ${name} : ${gives}`],
    locals: 'VAR',
    begin: '',
  };
}

/** IEC 61131-3 Structured Text, in the words that CODESYS, TwinCAT and OpenPLC have in common. */
export const structuredText: Target = {
  id: 'structured-text',
  name: 'Structured Text (CODESYS, TwinCAT, OpenPLC)',
  language: 'iecst',
  proof: 'run',
  parts: ['bytes', 'build', 'check', 'exchange'],
  transports: ['rtu', 'ascii', 'tcp', 'pdu'],
  sequences: true,
  write: (plan) => {
    const { file, names } = structuredTextOf(plan);
    return { files: [file], notes: names.notes };
  },
};

/** The file of a plan, and the names in it. */
export function structuredTextOf(plan: Plan): { readonly file: WrittenFile; readonly names: Names } {
  const arrays = new Map<string, string>();
  const names = new Names(iecNames, plan.options.names);
  // The types stand before what uses them: it is written once to know them.
  write(plan, new Lines(INDENT), names, arrays);
  const lines = new Lines(INDENT);
  head(plan, lines, arrays);
  write(plan, lines, names, arrays);
  return { file: lines.file(fileName(plan)), names };
}

const pascal = (words: string): string =>
  words.replace(/(?:^| )([a-z\d])/g, (_, letter: string) => letter.toUpperCase());

const fileName = ({ sequence, requests: [first] }: Plan): string =>
  `${sequence ? 'ModbusSequence' : pascal((first?.name ?? 'modbus').slice(0, LONGEST_FILE_NAME))}.st`;

function head(plan: Plan, lines: Lines, arrays: ReadonlyMap<string, string>): void {
  if (plan.options.comments) {
    for (const { about } of plan.requests) lines.add(comment(about));
    for (const text of wiring(plan)) lines.add(comment(text));
    lines.add('');
  }
  if (arrays.size === 0) return;
  for (const [name, of] of arrays) {
    lines.add('TYPE').inside(() => lines.add(`${name} : ${of};`));
    lines.add('END_TYPE');
  }
}

function write(plan: Plan, lines: Lines, names: Names, arrays: Map<string, string>): void {
  const { code, options, requests, sequence } = plan;
  const units = new Units(dialect(names, arrays), code, lines, options.comments, frameCapacity(plan));
  const exchanges = new Exchanges(units, plan);
  const uses = new Uses();
  for (const { body } of code.routines) uses.statements(body);
  helpers(units, uses);
  for (const texts of code.texts) units.texts(texts);
  for (const routine of code.routines) units.routine(routine);
  for (const request of requests) if (request.build === undefined) units.frame(request, frameRoutine(request));
  if (options.part !== 'exchange') return;
  if (sequence) sequenceBlock(units, exchanges, sequence, requests, 'modbus sequence');
  else for (const request of requests) requestBlock(units, exchanges, request);
}
