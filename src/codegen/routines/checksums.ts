import { CrcSteps, crcCatalogue, MOST_ASCII, MOST_RTU, twoTables } from '../../modbus/index.ts';
import {
  binary,
  type Code,
  convert,
  type Expression,
  number,
  type Parameter,
  type Routine,
  type Table,
} from '../code.ts';
import type { CrcWay } from '../options.ts';
import {
  byte,
  call,
  declare,
  element,
  giveBack,
  int,
  loop,
  name,
  plus,
  set,
  times,
  toInt,
  when,
  wordOf,
} from './terms.ts';

const MODBUS = crcCatalogue.find(({ name }) => name === 'CRC-16/MODBUS') as (typeof crcCatalogue)[number];
const START = 0xffff;
/** The polynomial with its bits the other way round, as the low bit is sent first. */
const POLYNOMIAL = 0xa001;
const BITS = 8;

const index = name('int', 'index');
const bytes = (comment: string): readonly Parameter[] => [
  { name: 'bytes', type: 'byte', size: MOST_RTU, comment },
  { name: 'length', type: 'int', lengthOf: 'bytes', comment: 'how many bytes of it' },
];
const length = name('int', 'length');
const crc = name('word', 'remainder');
const next: Expression = element('byte', 'bytes', index);

const crcRoutine = (about: readonly string[], body: Routine['body']): Routine => ({
  name: 'crc',
  about: ['The CRC of Modbus RTU. Its low byte is sent first.', ...about],
  parameters: bytes('what it is calculated of'),
  gives: { kind: 'value', type: 'word' },
  body,
});

const bitwise = (): Pick<Code, 'tables' | 'routines'> => {
  const shifted = binary(crc, '>>', int(1));
  const lowBit = binary(binary(crc, '&', number('word', 1)), '≠', number('word', 0));
  const body = [
    declare('remainder', number('word', START), true),
    loop('index', int(0), length, [
      set(crc, binary(crc, '^', convert('word', next))),
      loop('bit', int(0), int(BITS), [
        when(lowBit, [set(crc, binary(shifted, '^', number('word', POLYNOMIAL)))], [set(crc, shifted)]),
      ]),
    ]),
    giveBack(crc),
  ];
  return { tables: [], routines: [crcRoutine(['Bit by bit, with the polynomial A001.'], body)] };
};

const stepsOf = (): CrcSteps => new CrcSteps(MODBUS, new Uint8Array());

const oneTable = (): Pick<Code, 'tables' | 'routines'> => {
  const at = toInt(binary(binary(crc, '^', convert('word', next)), '&', number('word', 0xff)));
  const body = [
    declare('remainder', number('word', START), true),
    loop('index', int(0), length, [
      set(crc, binary(binary(crc, '>>', int(BITS)), '^', element('word', 'crc table', at))),
    ]),
    giveBack(crc),
  ];
  const table: Table = {
    name: 'crc table',
    type: 'word',
    values: Array.from(stepsOf().table),
    base: 16,
    comment: 'What a byte does to the CRC, by its value',
  };
  return { tables: [table], routines: [crcRoutine(['With one table, a step for each byte.'], body)] };
};

const inTwoTables = (): Pick<Code, 'tables' | 'routines'> => {
  const split = twoTables(stepsOf());
  if (split === undefined) return bitwise();
  const [first, second] = [name('byte', 'crc low'), name('byte', 'crc high')];
  const at = name('int', 'entry');
  const body = [
    declare('crc low', byte(START & 0xff), true),
    declare('crc high', byte(START >> BITS), true),
    loop('index', int(0), length, [
      declare('entry', toInt(binary(first, '^', next)), false),
      set(first, binary(second, '^', element('byte', 'crc table low', at))),
      set(second, element('byte', 'crc table high', at)),
    ]),
    giveBack(wordOf(second, first)),
  ];
  const table = (half: string, values: Uint8Array): Table => ({
    name: `crc table ${half}`,
    type: 'byte',
    values: [...values],
    base: 16,
    comment: `The ${half} bytes of what a byte does to the CRC`,
  });
  return {
    tables: [table('low', split.first), table('high', split.second)],
    routines: [crcRoutine(['With two tables of bytes, for the low and the high byte.'], body)],
  };
};

/** What calculates a CRC: `crc(bytes, length) → word`. */
export const crcWays: { readonly [Way in CrcWay]: () => Pick<Code, 'tables' | 'routines'> } = {
  bitwise,
  table: oneTable,
  'two-tables': inTwoTables,
};

const DIGITS = 10;
const ZERO = 0x30;
const UPPER = 0x41;
const LOWER = 0x61;

const character = name('byte', 'character');

/** `digit value(character) → int`: the value of a hexadecimal digit, or -1. */
const digitValue: Routine = {
  name: 'digit value',
  about: ['The value of a hexadecimal digit, or -1 if the character is none.'],
  parameters: [{ name: 'character', type: 'byte', comment: 'an ASCII character' }],
  gives: { kind: 'value', type: 'int' },
  body: [
    ...(
      [
        [ZERO, DIGITS, 0],
        [UPPER, 6, DIGITS],
        [LOWER, 6, DIGITS],
      ] as const
    ).map(([first, many, value]) =>
      when(binary(binary(character, '≥', byte(first)), 'and', binary(character, '≤', byte(first + many - 1))), [
        giveBack(plus(binary(toInt(character), '-', int(first)), int(value))),
      ]),
    ),
    giveBack(int(-1)),
  ],
};

const at = name('int', 'at');

/** `byte of digits(characters, at) → byte`. */
const byteOfDigits: Routine = {
  name: 'byte of digits',
  about: ['The byte that two hexadecimal digits stand for.'],
  parameters: [
    { name: 'characters', type: 'byte', size: MOST_ASCII, comment: 'ASCII characters' },
    { name: 'at', type: 'int', comment: 'the place of the first digit' },
  ],
  gives: { kind: 'value', type: 'byte' },
  body: [
    giveBack(
      convert(
        'byte',
        plus(
          times(16, call('int', 'digit value', element('byte', 'characters', at))),
          call('int', 'digit value', element('byte', 'characters', plus(at, int(1)))),
        ),
      ),
    ),
  ],
};

const value = name('int', 'value');

/** `digit of(value) → byte`: the character. */
const digitOf: Routine = {
  name: 'digit of',
  about: ['The upper-case hexadecimal digit of a value from 0 to 15.'],
  parameters: [{ name: 'value', type: 'int', comment: 'from 0 to 15' }],
  gives: { kind: 'value', type: 'byte' },
  body: [
    when(binary(value, '<', int(DIGITS)), [giveBack(convert('byte', plus(value, int(ZERO))))]),
    giveBack(convert('byte', plus(value, int(UPPER - DIGITS)))),
  ],
};

/** `lrc(characters, length) → byte`: of the bytes whose digits stand behind the colon, up to `length` characters in all. */
const lrc: Routine = {
  name: 'lrc',
  about: ['The LRC of the bytes whose digits follow the colon: the two’s complement of their sum.'],
  parameters: [
    { name: 'characters', type: 'byte', size: MOST_ASCII, comment: 'the frame, from its colon' },
    { name: 'length', type: 'int', lengthOf: 'characters', comment: 'how many characters of it, with the colon' },
  ],
  gives: { kind: 'value', type: 'byte' },
  body: [
    declare('sum', int(0), true),
    loop('index', int(0), binary(binary(length, '-', int(1)), '/', int(2)), [
      set(
        name('int', 'sum'),
        plus(
          name('int', 'sum'),
          toInt(call('byte', 'byte of digits', { kind: 'array', array: 'characters' }, plus(times(2, index), int(1)))),
        ),
      ),
    ]),
    giveBack(convert('byte', binary(int(256), '-', binary(name('int', 'sum'), '%', int(256))))),
  ],
};

/** What ASCII frames need: to be built (`digit of`), and both to be built and read. */
export const asciiRoutines = { digitOf, reading: [digitValue, byteOfDigits], lrc } as const;
