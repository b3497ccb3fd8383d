import { type Chance, numberOf } from './chance.ts';
import type { Parameter } from './parameters.ts';
import { sensible } from './sensible.ts';

const nonsense: readonly unknown[] = [
  Number.NaN,
  Number.POSITIVE_INFINITY,
  Number.NEGATIVE_INFINITY,
  1e9,
  -1e9,
  2 ** 53,
  1e300,
  -1,
  -0,
  0.5,
  65_536,
  10n,
  '',
  ' ',
  '\u0000\uD800',
  '99999999999999999999',
  '-1e999',
  'constructor',
  '__proto__',
  'toString',
  null,
  undefined,
  true,
  {},
  { length: -1 },
  Object.create(null),
  [],
  [null],
  [Number.NaN, -1, 1e9],
  [[[]]],
  new Array(3),
  new Uint8Array(0),
  Uint8Array.of(0xff, 0, 0x80),
  Float64Array.of(Number.NaN, 1e300),
  new Map([[1, 2]]),
  new Date(Number.NaN),
  /a/g,
  Symbol('nonsense'),
  () => undefined,
  () => Number.NaN,
];

/** Long ones come once in a hundred calls. */
const long: readonly unknown[] = [
  '1 '.repeat(20_000),
  'é'.repeat(40_000),
  'constructor,'.repeat(4000),
  new Uint8Array(30_000),
];

const bytes = [0x11, 0x03, 0x00, 0x6b, 0x00, 0x03, 0x76, 0x87];
const line = { baud: 19_200, dataBits: 8, parity: 'even', stopBits: 1 };
const known: readonly unknown[] = [
  ...Array.from({ length: 20 }, (_, number) => number),
  ...[40, 0xff, 0x100, 683, 1000, 19_200, 40_108, 0xffff],
  ...['rtu', 'ascii', 'tcp', 'pdu', 'request', 'response', 'reply', 'exception', 'hex', 'decimal', 'de', 'c'],
  ...[
    'coil',
    'discrete-input',
    'input-register',
    'holding-register',
    'u16',
    'i32',
    'f32',
    'text',
    'bits',
    'ABCD',
    'CDAB',
  ],
  ...[
    'zero-based',
    'five-digit',
    'one-based',
    '8E1',
    '40108',
    '4x108',
    '0x2A9',
    '30 Hz',
    '1,5',
    '1.5 ms',
    '11 03 00 6B 00 03 76 87',
  ],
  ...[
    'address',
    'startAddress',
    'quantity',
    'registers',
    'value',
    'unitId',
    'CRC-16/MODBUS',
    'rtu/request?functionCode=3',
  ],
  Uint8Array.from(bytes),
  Uint8Array.of(0x11, 0x83, 0x02, 0xc1, 0x34),
  bytes,
  [0x1234, 1, 0xffff],
  [true, false, true],
  line,
  { format: { dataBits: 8, parity: 'even', stopBits: 1 }, bit: 1 },
  { transport: 'rtu', direction: 'request' },
  { transport: 'tcp', direction: 'response', request: Uint8Array.from(bytes) },
  { transport: 'rtu', direction: 'request', unitId: 17, functionCode: 3, fields: { startAddress: 107, quantity: 3 } },
  {
    transport: 'tcp',
    direction: 'response',
    unitId: 1,
    transactionId: 1,
    functionCode: 6,
    fields: { address: 1, value: 2 },
  },
  { name: 'own', width: 16, polynomial: 0x8005, init: 0xffff, reflectIn: true, reflectOut: true, xorOut: 0 },
  { transport: 'rtu', kind: 'request', texts: { unitId: '1', functionCode: '3' }, force: {}, answering: '' },
  { line: 1, cells: ['name', 'table', 'address'] },
  [
    { line: 1, cells: ['name', 'address'] },
    { line: 2, cells: ['a', '1'] },
  ],
  { table: 'holding-register', address: 107 },
  { factor: 0.5, offset: 1, unit: 'Hz' },
];

/** Places for what is kept, each filled by a few names, so that one name more changes few. */
const PLACES = 997;
/** Arguments that are remembered of a parameter. */
const LEARNED = 8;

/** Arguments for calls: some that make sense, some that do not, and what functions took and answered. */
export class Arguments {
  private readonly kept: unknown[] = [];
  private readonly learned = new Map<string, unknown[]>();

  /** A small value is an argument from now on; long ones would make ever longer ones. */
  keep(name: string, value: unknown): void {
    if (value !== undefined && isSmall(value)) this.kept[numberOf(name) % PLACES] = value;
  }

  /** An argument that fitted, or an answer, for parameters of a name. */
  learn(name: string, value: unknown, chance: Chance): void {
    if (value === undefined || !isSmall(value)) return;
    const values = this.learned.get(name) ?? [];
    values[values.length < LEARNED ? values.length : chance.below(LEARNED)] = value;
    this.learned.set(name, values);
  }

  /** All arguments of a call: all fit as far as is known, or one does not, or each by chance. */
  takeAll(parameters: readonly Parameter[], chance: Chance): readonly unknown[] {
    const kind = chance.below(3);
    const spoilt = chance.below(parameters.length + 1);
    return parameters.map((parameter, index) => {
      const value = this.fitting(parameter, chance);
      if (kind === 0) return value;
      return kind === 1 && index !== spoilt ? value : chance.below(2) === 0 ? this.take(chance) : spoil(value, chance);
    });
  }

  take(chance: Chance): unknown {
    if (chance.below(300) === 0) return chance.oneOf(long);
    const kind = chance.below(4);
    if (kind === 0) return chance.oneOf(nonsense);
    return kind === 1 ? spoil(this.any(chance), chance) : this.any(chance);
  }

  private fitting(parameter: Parameter, chance: Chance): unknown {
    if (parameter.kind === 'fields')
      return Object.fromEntries(parameter.fields.map(([key, value]) => [key, this.fitting(value, chance)]));
    const values = [...(sensible[parameter.name] ?? []), ...(this.learned.get(parameter.name) ?? [])];
    return values.length === 0 || chance.below(8) === 0 ? this.any(chance) : chance.oneOf(values);
  }

  private any(chance: Chance): unknown {
    const own = chance.oneOf(known);
    const place = chance.below(PLACES);
    return chance.below(4) === 0 ? own : (this.kept[place] ?? own);
  }
}

/** A copy of an argument with something in it that makes no sense. Lengths stay, since a list of a length needs memory for it. */
function spoil(value: unknown, chance: Chance, depth = 0): unknown {
  if (typeof value !== 'object' || value === null || depth > 4 || ArrayBuffer.isView(value))
    return chance.oneOf(nonsense);
  const keys = Object.keys(value).filter((key) => key !== 'length');
  if (keys.length === 0 || chance.below(4) === 0) return chance.oneOf(nonsense);
  const key = chance.oneOf(keys);
  const copy: object = Array.isArray(value) ? [...value] : { ...value };
  Object.defineProperty(copy, key, { value: spoil(Reflect.get(value, key), chance, depth + 1), enumerable: true });
  return copy;
}

function isSmall(value: unknown, depth = 0): boolean {
  if (typeof value === 'string') return value.length < 500;
  if (typeof value !== 'object' || value === null) return typeof value !== 'function';
  if (ArrayBuffer.isView(value)) return value.byteLength < 500;
  const values = Object.values(value);
  return depth < 6 && values.length < 40 && values.every((one) => isSmall(one, depth + 1));
}
