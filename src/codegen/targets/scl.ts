import type { Name, Scalar, Table } from '../code.ts';
import { Names } from '../names.ts';
import type { Plan } from '../plan.ts';
import { plainText } from '../print.ts';
import type { Target } from '../target.ts';
import { Lines } from '../written.ts';
import { Exchanges, frameRoutine } from './iec/block.ts';
import type { Dialect } from './iec/dialect.ts';
import { requestBlock } from './iec/request-block.ts';
import { sequenceBlock } from './iec/sequence-block.ts';
import { frameCapacity, Units } from './iec/units.ts';
import { iecNames } from './iec/words.ts';

const INDENT = '    ';
const TYPES: Readonly<Record<Scalar, string>> = {
  byte: 'Byte',
  word: 'Word',
  dword: 'DWord',
  int: 'DInt',
  bool: 'Bool',
  real: 'LReal',
};
const TABLES = '"ModbusTables"';

/** In SCL, local names are marked with `#`, names of blocks stand in quotes, and constants have no arrays. */
function dialect(names: Names): Dialect {
  const quoted = (name: Name, kind: 'routine' | 'type') => `"${names.of(name, kind)}"`;
  return {
    types: TYPES,
    conversions: (type) => TYPES[type].toUpperCase(),
    timer: 'TON_TIME',
    string: 'String',
    time: 'Time',
    declared: (name, kind) => (kind === 'routine' || kind === 'type' ? quoted(name, kind) : names.of(name, kind)),
    used: (name, kind) => (kind === 'routine' || kind === 'type' ? quoted(name, kind) : `#${names.of(name, kind)}`),
    result: (name) => `#${names.of(name, 'routine')}`,
    comment: (text) => `// ${plainText(text)}`,
    // The number of places has no sign.
    shift: (way, value, by) => `${way}(IN := ${value}, N := ${/^\d+$/.test(by) ? by : `DINT_TO_UINT(${by})`})`,
    // Here the bits are copied.
    float: (bits) => `REAL_TO_LREAL(DWORD_TO_REAL(${bits}))`,
    floor: (of) => `FLOOR_LREAL(${of})`,
    array: (type, size) => `Array[0..${size - 1}] of ${TYPES[type]}`,
    arrayValues: false,
    table: (name) => `${TABLES}.${names.of(name, 'table')}`,
    head: (kind, name, gives) => [
      gives === undefined ? `${kind} ${name}` : `${kind} ${name} : ${gives}`,
      "{ S7_Optimized_Access := 'TRUE' }",
      'VERSION : 0.1',
    ],
    locals: 'VAR_TEMP',
    begin: 'BEGIN',
  };
}

/** Siemens S7-1200 and S7-1500: an external source file of TIA Portal. */
export const scl: Target = {
  id: 'scl',
  name: 'Siemens SCL (S7-1200, S7-1500)',
  language: 'iecst',
  proof: 'rules',
  parts: ['bytes', 'build', 'check', 'exchange'],
  transports: ['rtu', 'ascii', 'tcp', 'pdu'],
  sequences: true,
  write: (plan) => {
    const { code, options, requests, sequence } = plan;
    const names = new Names(
      { ...iecNames, styles: { ...iecNames.styles, variable: 'camel', table: 'camel' } },
      options.names,
    );
    const lines = new Lines(INDENT);
    const units = new Units(dialect(names), code, lines, options.comments, frameCapacity(plan));
    units.printer.remark(lines, ...requests.map(({ about }) => about), ...wiring(plan));
    // Frames are written byte by byte.
    const tables = code.tables.filter(({ rows }) => rows === undefined);
    if (tables.length > 0) dataBlock(lines, tables, units, names);
    for (const texts of code.texts) units.texts(texts);
    for (const routine of code.routines) units.routine(routine);
    for (const request of requests) if (request.build === undefined) units.frame(request, frameRoutine(request));
    if (options.part === 'exchange') {
      const exchanges = new Exchanges(units, plan);
      if (sequence) sequenceBlock(units, exchanges, sequence, requests, 'modbus sequence');
      else for (const request of requests) requestBlock(units, exchanges, request);
    }
    return { files: [lines.file('modbus.scl')], notes: names.notes };
  },
};

/** Tables stand in a data block, as SCL has no constant arrays. */
function dataBlock(lines: Lines, tables: readonly Table[], units: Units, names: Names): void {
  lines.add('').add(`DATA_BLOCK ${TABLES}`).add("{ S7_Optimized_Access := 'TRUE' }").add('VERSION : 0.1');
  lines.add('NON_RETAIN').add('VAR');
  lines.inside(() => {
    for (const { name, type, values } of tables)
      lines.add(`${names.of(name, 'table')} : Array[0..${values.length - 1}] of ${TYPES[type]};`);
  });
  lines.add('END_VAR').add('BEGIN');
  lines.inside(() => {
    for (const { name, type, values } of tables)
      for (const [index, value] of values.entries())
        lines.add(`${names.of(name, 'table')}[${index}] := ${units.value(type, value)};`);
  });
  lines.add('END_DATA_BLOCK');
}

function wiring({ options: { part }, transport, requests }: Plan): readonly string[] {
  const use = ['TIA Portal: add the file under "External source files", and generate blocks from it.'];
  if (part !== 'exchange') return use;
  const answered = requests.some(({ check }) => check !== undefined);
  return [
    ...use,
    'The block knows no port. Call it in every cycle, with its instance in a data block of yours:',
    ...(answered ? ['append the bytes that have come in to rxBuffer[rxCount], and count them in rxCount;'] : []),
    'when txStart is TRUE, send txBuffer[0] to txBuffer[txCount - 1].',
    transport === 'tcp'
      ? 'TCON opens the connection, TSEND sends (LEN := txCount), TRCV with ADHOC := TRUE receives.'
      : 'Send_P2P sends (LENGTH := txCount), Receive_P2P receives, on a CM PtP or CB 1241 set to free port.',
  ];
}
