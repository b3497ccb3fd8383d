import type { ChecksumMatch } from '../../diagnosis/index.ts';
import { dictionary, hexDigits } from '../../modbus/index.ts';
import type { InputKind, OwnFault, PolynomialKind, SortKey } from '../../workbench/index.ts';
import { bytesOf, plural, sizeOf, word } from './common.ts';
import { pasting } from './pasting.ts';

const MEGA = 1_000_000;
const perSecond = (speed: number) => `${Math.round(speed / MEGA)} MB/s`;

function ownFault(fault: OwnFault): string {
  switch (fault.code) {
    case 'missing':
      return 'Type a value.';
    case 'not-a-number':
      return `“${fault.text}” is not a number. Write decimal 40961 or hexadecimal 0xA001, A001h or 16#A001.`;
    case 'out-of-range':
      return `Whole numbers from ${fault.least} to ${fault.most} (0x${hexDigits(fault.most, 1)}).`;
  }
}

const wholeOf = (at: number | undefined) => (at === undefined ? 'of all bytes' : 'of all bytes before it');

const SWAPPED_ELSEWHERE = 'Some calculators print it with its bytes swapped.';

const abouts: Readonly<Record<string, string>> = dictionary({
  LRC: "Modbus ASCII: the two's complement of the sum of the bytes, without the colon, CR and LF.",
  'SUM-8': 'The sum of the bytes modulo 256. Not used by Modbus.',
  'XOR-8': 'All bytes xored. Other protocols call it LRC; Modbus does not use it.',
  'CRC-16/KERMIT': SWAPPED_ELSEWHERE,
  'CRC-16/DNP': SWAPPED_ELSEWHERE,
  Sick: 'An algorithm of its own, not a CRC: each byte goes in together with the byte before it. Calculators print it with its bytes swapped.',
});

/** What the Checksum view says. */
export const checksum = {
  title: 'Framewright: checksums',
  input: 'Input',
  readAs: pasting.readAs,
  problems: pasting.problems,
  kind: 'Input is',
  kinds: { bytes: 'Bytes', text: 'Text' } satisfies Record<InputKind, string>,
  kindHints: { bytes: 'Hexadecimal, decimal, a dump, a log, code', text: 'The characters themselves, as UTF-8' },
  labels: { bytes: 'Bytes, written in any way', text: 'Text, taken as UTF-8' },
  hints: {
    bytes: 'Anything that says bytes: hexadecimal, decimal, a dump, a line of a log.',
    text: 'The bytes of the characters themselves.',
  },
  body: 'Frame without its checksum',
  whole: 'Frame as it is sent',
  count: (count: number) => plural(count, 'byte'),
  openFile: 'Open a file…',
  closeFile: 'Close the file',
  size: (size: number) => (size < 1000 ? bytesOf(size) : `${sizeOf(size)}, ${bytesOf(size)}`),
  computing: 'Computing…',
  progress: (done: number, size: number, speed: number | undefined) =>
    speed === undefined ? `Computing…` : `${sizeOf(done)} of ${sizeOf(size)}, ${perSecond(speed)}`,
  took: (speed: number) => `Read and computed at ${perSecond(speed)}.`,
  cancel: 'Cancel',
  cancelled: 'Cancelled. Nothing is known of these bytes.',
  failed: 'The file could not be read. It may have been moved or changed, or what reads it did not load.',
  again: 'Start again',
  result: 'Checksums',
  none: 'None.',
  number: 'Number',
  wire: 'On the wire',
  swapped: 'Swapped',
  lowFirst: 'Low byte first',
  highFirst: 'High byte first',
  withIt: 'With the checksum',
  endsWithCrc: 'These bytes end with their own CRC: over both the result is 0.',
  about: (name: string) => abouts[name] ?? '',
  steps: 'Step by step',
  stepsHint: 'How each bit of these bytes changes the register.',
  copy: (text: string, of: string) => `Copy ${text}, ${of}`,
  copied: (text: string) => `Copied ${text}`,
  copyFailed: 'The browser refused. Select the text and copy it:',

  unknown: (name: string, own: boolean, instead: string) =>
    own
      ? `The parameters below do not make a CRC yet. Until they do, ${instead} is used.`
      : `No algorithm is called “${name}”. ${instead} is used instead.`,
  all: 'All algorithms',
  allHint: (count: number) => `${count} checksums over the input; choose one, or find one by its value`,
  order: 'In the order of',
  unsorted: 'the catalogue',
  search: 'Search',
  searchHint: 'Name, value or polynomial: CCITT, 0xC278, A001',
  shown: (shown: number, all: number) => `${shown} of ${all}`,
  nothing: (search: string) => `Nothing matches “${search}”.`,
  clearSearch: 'Show all',
  columns: {
    name: 'Name',
    value: 'Value',
    width: 'Bits',
    poly: 'Polynomial',
    reversed: 'Reversed',
    koopman: 'Koopman',
    init: 'Start',
    reflected: 'Reflected',
    xorout: 'Final xor',
    check: 'Check',
    residue: 'Residue',
  } satisfies Record<SortKey, string>,
  chooseIt: 'choose it',
  bothOrders: 'High byte first, and low byte first',
  noCrc: 'not a CRC',
  reflections: (refin: boolean, refout: boolean) =>
    refin === refout ? (refin ? 'yes' : 'no') : refin ? 'in only' : 'out only',

  own: 'Own parameters',
  ownTitle: 'Own parameters',
  ownWrong: 'A parameter is missing or cannot be read: it is marked.',
  ownHint: 'A CRC that is not in the list.',
  parameters: {
    width: 'Bits',
    poly: 'Polynomial',
    init: 'Start value',
    xorout: 'Final xor',
    refin: 'Input reflected',
    refout: 'Output reflected',
  },
  parameterHints: {
    width: '1 to 32.',
    poly: 'Without its top bit: 0x8005.',
    init: 'Not reflected. 0 if left empty.',
    xorout: '0 if left empty.',
  },
  polyAs: 'Polynomial written',
  polynomialKinds: {
    normal: 'normal (0x8005)',
    reversed: 'reversed (0xA001)',
    koopman: 'Koopman (0xC002)',
  } satisfies Record<PolynomialKind, string>,
  isNumber: (value: number, hex: string) => `${value}, ${hex}`,
  ownFault,
  which: 'Which checksum is this?',
  whichHint: 'Finds the algorithm, the order of the bytes and the part of the input that give a value.',
  claim: 'Value to explain',
  claimHint:
    'As it was printed or sent: 0x1AF3, F3 1A, 6899. Left empty, the value at the end of the input is looked at.',
  notAClaim: (text: string) => `“${text}” is not a value of 1, 2 or 4 bytes. Write 0x1AF3, F3 1A or 6899.`,
  matches: 'What gives this value',
  match: ({ from, to, at, lowFirst, start, text }: ChecksumMatch, length: number) => {
    const all = from === 0 && to === (at ?? length);
    const over =
      text === undefined ? (all ? wholeOf(at) : `of bytes ${from + 1} to ${to} only`) : `of the text “${text}”`;
    const begun = start === undefined ? '' : `, begun with ${word(start)}`;
    return `${over}${begun}, ${lowFirst ? 'low byte first' : 'high byte first'}.`;
  },
  chance: (chance: number) =>
    chance > 0.5
      ? `Chance alone gives about ${Math.max(1, Math.round(chance))} such match.`
      : chance > 0.001
        ? `Chance alone gives one in ${Math.round(1 / chance)} tries.`
        : 'Hardly by chance.',
  chooseMatch: 'Choose',
  chooseNamed: (name: string) => `Choose ${name}`,
  noMatch:
    'No named algorithm gives this value, over all bytes or with up to 4 left out at either end, in either byte order.',
  noneAtEnd: 'The input does not end with a checksum of the bytes before it. Type the value to explain.',
  waiting: 'The input is still being read.',
  tooLong: (most: number) => `Inputs of up to ${most} bytes are searched.`,
  card: 'Test card',
  cardHint: 'Known values to check your own implementation against, and wrong ones in print.',
  useOwn: 'Use these parameters',
  fromChosen: 'Use those of the chosen algorithm',
};
