import * as library from '../../../src/framewright.ts';
import * as sequences from '../../../src/sequences/index.ts';
import * as workbench from '../../../src/workbench/index.ts';

const request = Uint8Array.of(0x11, 0x03, 0x00, 0x6b, 0x00, 0x03, 0x76, 0x87);
const reply = Uint8Array.of(0x11, 0x03, 0x06, 0x02, 0x2b, 0x00, 0x00, 0x00, 0x64, 0xc8, 0xba);
const profiles = library.builtInProfiles;
const registers = profiles.flatMap((profile) => profile.registers.slice(0, 2));
const readings = [
  library.decodeFrame(request, { transport: 'rtu', direction: 'request' }),
  library.decodeFrame(reply, { transport: 'rtu', direction: 'response', request }),
];
const drafts = ['rtu/request?functionCode=3', 'tcp/reply?functionCode=6&address=1', 'ascii/exception?functionCode=16']
  .map((link) => workbench.readLink(link)?.draft)
  .filter((draft) => draft !== undefined);
const serial = { baud: 19_200, dataBits: 8, parity: 'even', stopBits: 1 };
const places = [
  { list: 'steps', at: [0] },
  { list: 'finally', at: [0] },
];
const numbers = [0, 1, 2, 7, 40];
const texts = ['', '1', '0x2A9', '30 Hz', 'pump', '11 03 00 6B 00 03 76 87', '40108'];

const word = Object.assign(() => 'word', { toString: () => 'word' });
/** Stands for the sentences of any function: a text, a function and a dictionary alike. */
const words: unknown = new Proxy(word, {
  get: (all, key) => (typeof key === 'string' ? words : key === Symbol.toPrimitive ? all : undefined),
});

/** What usually stands for a parameter of a name. */
export const sensible: Readonly<Record<string, readonly unknown[]>> = library.dictionary({
  a: [1n, library.fraction(1, 3), request],
  b: [1n, library.fraction(3, 2), reply],
  address: [0, 107, 683, 0xffff],
  algorithm: [{ width: 16, poly: 0x8005, init: 0xffff, refin: true, refout: true, xorout: 0 }],
  andMask: [0xf2],
  at: numbers,
  baud: [1200, 9600, 19_200],
  bit: [52, 1],
  bits: [8, 10, 11, 16],
  bytes: [request, reply],
  characters: [8, 2.5],
  checksum: ['crc', 'none', 'CRC-16/MODBUS'],
  context: [
    { transport: 'rtu', direction: 'request' },
    { transport: 'tcp', direction: 'response', request },
  ],
  convention: ['zero-based', 'one-based', 'five-digit'],
  dataBits: [7, 8],
  denominator: [3n],
  decimals: [0, 2],
  direction: ['request', 'response'],
  draft: drafts,
  edges: [[0, 104, 208, 1041]],
  evaluation: drafts.map(workbench.evaluate),
  factor: [1, 0.5, library.fraction(1, 10)],
  least: [0],
  most: [0xffff],
  field: ['startAddress', 'quantity', 'address', 'value'],
  fields: [{ startAddress: 107, quantity: 3 }, readings[0]?.fields],
  first: numbers,
  format: [{ dataBits: 8, parity: 'even', stopBits: 1 }, 'hex', 'c', 'csv', 'markdown'],
  from: numbers,
  functionCode: [3, 6, 16, 0x64],
  hash: ['rtu/request?functionCode=3'],
  hex: ['110300'],
  index: numbers,
  init: [0, 0xffff],
  input: [
    { transport: 'rtu', direction: 'request', unitId: 1, functionCode: 3, fields: { startAddress: 1, quantity: 3 } },
  ],
  items: numbers,
  kind: ['request', 'reply', 'exception'],
  line: [serial],
  link: ['rtu/request?functionCode=3'],
  list: ['steps', 'finally', profiles],
  mode: ['rtu', 'ascii'],
  name: ['address', 'startAddress', 'pump', 'CRC-16/MODBUS'],
  names: [[{ number: 1, name: 'on' }]],
  numerator: [1n],
  offset: [0, -40, library.fraction(0)],
  orMask: [0x25],
  order: ['ABCD', 'CDAB', 'BADC'],
  parity: ['none', 'even'],
  path: ['startAddress', 'registers[0]'],
  place: places,
  poly: [0x8005, 7],
  profile: profiles,
  profiles: [profiles],
  quantity: [1, 3],
  raw: [0, 300, 300n],
  reading: readings,
  received: [reply],
  refin: [true, false],
  refout: [true, false],
  register: [...registers, 0x1234],
  registers: [1, 2, [0x1234, 1, 0xffff], [1], registers],
  reply: [reply, readings[1]],
  request: [request, readings[0]],
  row: [['name', 'table', 'address']],
  rows: [
    [
      ['name', 'address'],
      ['a', '1'],
    ],
  ],
  scale: [
    { factor: library.fraction(1, 10), offset: library.fraction(0) },
    { factor: 0.5, offset: 1, unit: 'Hz' },
  ],
  sequence: sequences.builtInSequences,
  sequences: [sequences.builtInSequences],
  serial: [serial],
  stopBits: [1, 2],
  table: ['holding-register', 'coil'],
  text: texts,
  texts: [{ unitId: '1', functionCode: '3' }, ...sequences.builtInSequences],
  to: numbers,
  traits: [[]],
  transport: ['rtu', 'ascii', 'tcp'],
  type: ['u16', 'i32', 'f32', 'text'],
  typed: texts,
  unit: ['Hz', ''],
  value: [0, 1, 300, '30 Hz', 1.5, library.fraction(1, 3)],
  width: [8, 16, 32],
  words: [words, [0x1234, 1]],
  xorout: [0, 0xffff],
});
