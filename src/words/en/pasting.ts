import {
  type ByteNotation,
  formatBytes,
  formatHex,
  type SetAside,
  type TextProblem,
  type TextProblemCode,
} from '../../notation/index.ts';
import { bytesOf } from './common.ts';

/** What each way to write bytes is called. */
const readings: Readonly<Record<ByteNotation, string>> = {
  hex: 'hexadecimal',
  decimal: 'decimal',
  binary: 'binary',
  escapes: 'a string with escapes',
  'ascii-frame': 'an ASCII frame',
  hexdump: 'a hex dump',
  'hexdump-words': 'a dump of words, low byte first',
};

const bases: Readonly<Record<2 | 10 | 16, string>> = { 2: 'binary', 10: 'decimal', 16: 'hexadecimal' };

/** Why numbers are not taken for bytes. */
const asides: Readonly<Record<SetAside, string>> = {
  words: 'words stand around these numbers',
  comment: 'these numbers are in a comment',
  repeated: 'the text says them again',
  address: 'this is the address of a network card',
  headers: 'these are headers of a packet of the network (Ethernet, IP, TCP or UDP)',
};

/** What could not be read in a text, one sentence or two. */
const problems: { readonly [C in TextProblemCode]: (problem: Extract<TextProblem, { code: C }>) => string } = {
  'nibble-missing': () => 'One digit here, while the other bytes have two. It is read with a 0 in front.',
  'odd-digits': ({ digits }) =>
    `${digits} digits cannot be divided into whole bytes. What is left over at the end is not read.`,
  'value-over-255': ({ got }) => `${got} does not fit into a byte. The largest is 255.`,
  'not-a-byte': () => 'This is not a byte and is left out.',
  'not-of-base': ({ base }) => `This is not a ${bases[base]} number and is left out.`,
  'character-unknown': () => 'This character is not a byte: its code does not fit into one.',
  'escape-unknown': () => 'This escape is not known and is left out. Known are \\x01, \\001, \\n and the like.',
  'left-out': () => 'The text leaves bytes out here.',
  'set-aside': ({ why }) => `Not taken for bytes: ${asides[why]}.`,
  'checksum-said': ({ got, expected }) => {
    if (got === expected)
      return `The text says the checksum ${formatHex(got, 4)}: that is the CRC of the bytes before.`;
    if (got === ((expected & 0xff) << 8) + (expected >> 8)) {
      return `The text says the checksum ${formatHex(got, 4)}: the CRC of the bytes before, in the order in which it is sent.`;
    }
    return `The text says the checksum ${formatHex(got, 4)}. The CRC of the bytes before is ${formatHex(expected, 4)}.`;
  },
  'no-bytes': () => 'No bytes found in this text.',
};

/** How many bytes of another reading are shown. */
const SHOWN = 16;

/** What the page says of a pasted text. */
export const pasting = {
  readings,
  problems,
  readAs: (reading: ByteNotation) => `Read as ${readings[reading]}.`,
  otherwise: (reading: ByteNotation, bytes: Uint8Array) =>
    `As ${readings[reading]} it would be ${formatBytes(bytes.subarray(0, SHOWN))}${bytes.length > SHOWN ? ` … (${bytesOf(bytes.length)})` : ''}.`,
  choose: (reading: ByteNotation) => `Read as ${readings[reading]}`,
  directions: { request: 'request', response: 'reply', tx: 'sent', rx: 'received' },
};
