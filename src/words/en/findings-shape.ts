import type { OtherProtocol } from '../../diagnosis/index.ts';
import { byteHex, bytesOf, plural } from './common.ts';
import type { WordsFor } from './finding-words.ts';

const NOISE = {
  'too-fast': (times: number | undefined) => ({
    why: `In every byte the bits come in groups of ${times}: the receiver samples ${times} times as fast as the sender sends.`,
    todo: `Divide the receiver's speed by ${times}, or multiply the sender's.`,
  }),
  'too-slow': (times: number | undefined) =>
    times === 3 / 4
      ? {
          why: 'Start and stop bits show where a receiver at three quarters of the speed sees them.',
          todo: "Try four thirds of the receiver's speed: 19200 instead of 14400.",
        }
      : {
          why: 'In every byte the bit is set in which a receiver at half the speed sees the stop bit.',
          todo: "Try twice the receiver's speed.",
        },
  parity: () => ({
    why: 'All bytes have the same parity: the eighth bit is a parity bit, not data.',
    todo: 'Set the receiver to 7 data bits with parity, as ASCII mode uses, or the sender to 8.',
  }),
  polarity: () => ({
    why: 'With all ones and zeros exchanged these bytes are a frame whose CRC holds.',
    todo: 'Exchange the two wires (A and B), or switch off the inversion of the adapter.',
  }),
  'bit-order': () => ({
    why: 'With the bits of each byte in reverse these bytes are a frame whose CRC holds.',
    todo: 'Set the receiver to the lowest bit first, as UARTs are.',
  }),
  constant: () => ({
    why: 'All bytes are the same. A line that is held low reads as 00, one that nothing drives as 00 or FF.',
    todo: 'Check power, wiring, bias resistors, and that the driver is switched off after sending.',
  }),
  unknown: () => ({
    why: 'No function, length or checksum fits, in any transport. Nothing in the bits tells why.',
    todo: 'Compare speed, parity and stop bits of both sides, exchange A and B, and check termination and ground.',
  }),
} as const;

const SPEAK = 'Read it with a program for that protocol, or set the device to Modbus if it can speak it.';

/** What each protocol is, and what shows it. */
const OTHERS: Readonly<Record<OtherProtocol, { readonly is: string; readonly marks: string; readonly todo: string }>> =
  {
    daly: {
      is: "Daly's battery protocol",
      marks: 'It begins with A5, and its fourth byte, 08, counts the data bytes',
      todo: `${SPEAK} Some of these batteries speak Modbus as well, as unit 0x81 or 0xD2.`,
    },
    'jk-bms': {
      is: 'the protocol of JK batteries',
      marks: 'It begins with the marks of that protocol',
      todo: `${SPEAK} In the settings of these batteries the protocol of the RS-485 port is a choice.`,
    },
    'jbd-bms': {
      is: 'the protocol of JBD and Xiaoxiang batteries',
      marks: 'It begins with DD, and its fourth byte counts the data bytes',
      todo: SPEAK,
    },
    pylontech: {
      is: 'the protocol of Pylontech batteries',
      marks: 'It begins with a tilde and has nothing but hexadecimal digits behind it',
      todo: SPEAK,
    },
    sml: {
      is: 'SML, the protocol of electricity meters',
      marks: 'It begins with 1B four times and 01 four times',
      todo: 'Read it with a program for SML: the meter sends it by itself through its optical port.',
    },
    'dl-t-645': {
      is: 'DL/T 645, the protocol of electricity meters',
      marks: 'It has 68, six bytes of address, and 68 again',
      todo: `${SPEAK} Many of these meters can be switched to Modbus in their menu.`,
    },
    'm-bus': {
      is: 'M-Bus (EN 13757)',
      marks: 'Its marks and lengths stand where they belong: 68 L L 68 … 16, or 10 … 16',
      todo: `${SPEAK} M-Bus has a line and levels of its own: an RS-485 adapter does not fit.`,
    },
    nmea: {
      is: 'an NMEA 0183 sentence',
      marks: 'It begins with $ or ! and ends with an asterisk and two digits',
      todo: SPEAK,
    },
    text: {
      is: 'text',
      marks: 'All bytes are printable characters and line ends, and not only hexadecimal digits',
      todo: 'If a device should answer here, its port may be a console: look in its manual how Modbus is switched on.',
    },
  };

const FRONT = 'Discard what comes before a silence of 3.5 characters, and switch the driver on only to send.';

/** Findings about the shape: where frames begin and end. */
export const shape: WordsFor<
  | 'echo'
  | 'truncated-echo'
  | 'stray-leading'
  | 'stray-trailing'
  | 'stray-around'
  | 'stray-leading+truncated'
  | 'truncated'
  | 'fragments'
  | 'merged'
  | 'rotated'
  | 'byte-count'
  | 'extra-bytes'
  | 'noise'
  | 'ascii-line-end'
  | 'hex-of-ascii-frame'
  | 'mbap-length'
  | 'other-protocol'
  | 'envelope'
> = {
  echo: ({ wrong, rest }) => ({
    title: 'This is the request itself',
    why: `The bytes are those of the request${wrong > 0 ? `, but for ${plural(wrong, 'byte')}` : ''}: the receiver heard its own sender.${rest > 0 ? ` ${bytesOf(rest)} follow.` : ' No reply follows.'}`,
    todo: 'Switch off the echo of the adapter, or discard as many bytes as were sent. Then wait for the reply.',
  }),
  'truncated-echo': ({ missing, wrong }) => ({
    title: 'This is the beginning of the request',
    why: `The bytes are those of the request without its last ${missing === 1 ? 'byte' : bytesOf(missing)}${wrong > 0 ? `; ${plural(wrong, 'byte')} came out wrong` : ''}: the receiver heard its own sender and stopped early.`,
    todo: 'Switch off the echo of the adapter, or discard as many bytes as were sent. Then wait for the reply.',
  }),
  'stray-leading': ({ leading, previous }) => ({
    title: `${bytesOf(leading)} too many in front`,
    why: `After ${bytesOf(leading)} a whole frame follows, and its checksum holds.${previous ? ' What comes first is the end of the previous frame.' : ' A line that is switched between sending and receiving often reads as 00 or FF.'}`,
    todo: previous ? 'Empty the receive buffer before each request.' : FRONT,
  }),
  'stray-trailing': ({ trailing, zero }) => ({
    title: `${bytesOf(trailing)} too many behind`,
    why: `A whole frame with a checksum that holds is followed by ${bytesOf(trailing)}${zero ? ' of zero. The CRC holds with zeros behind it as well; only the length tells' : ''}.`,
    todo: 'Stop reading where the frame ends by its own length. A driver switched off late often leaves a 00 or FF.',
  }),
  'stray-around': ({ leading, trailing }) => ({
    title: 'Bytes too many in front and behind',
    why: `A whole frame with a checksum that holds lies between ${bytesOf(leading)} and ${bytesOf(trailing)} that belong to no frame.`,
    todo: `${FRONT} Check the bias resistors of the line.`,
  }),
  'stray-leading+truncated': ({ leading, missing }) => ({
    title: 'Shifted: bytes too many in front, and the end missing',
    why: `Behind ${bytesOf(leading)} a frame begins, and of its end ${bytesOf(missing)} ${missing === 1 ? 'is' : 'are'} missing: what came in front took its place.`,
    todo: 'Empty the receive buffer before each request, and do not stop after the number of bytes you await.',
  }),
  truncated: ({ missing, has }) => ({
    title: `Incomplete: ${bytesOf(missing)} missing`,
    why: `By its own fields the frame has at least ${has + missing} bytes; ${has} ${has === 1 ? 'is' : 'are'} here.`,
    todo: 'Keep reading until the line is silent. Check the time-out, the size of the buffer, and whether the log cuts lines off.',
  }),
  fragments: ({ lines }) => ({
    title: `One frame in ${lines} pieces`,
    why: `Together with the pieces next to it these bytes are one whole frame whose checksum holds.`,
    todo: 'Join pieces until the frame is complete. USB adapters deliver in pieces; their latency timer can be shortened.',
  }),
  merged: ({ frames, between }) => ({
    title: `${frames} frames in one`,
    why: `${frames} whole frames whose checksums hold follow one another${between > 0 ? `, with ${bytesOf(between)} that belong to none` : ''}.`,
    todo: 'Split where each frame ends by its own length. A request and its reply often arrive in one read.',
  }),
  rotated: ({ by }) => ({
    title: 'The end comes first',
    why: `With the first ${bytesOf(by)} moved behind the others this is a whole frame whose CRC holds.`,
    todo: 'Bytes of an earlier frame are left in the buffer: empty it before each request, and read each frame to its end.',
  }),
  'byte-count': ({ got, expected }) => ({
    title: got === undefined ? 'The byte count is missing' : 'The byte count is wrong',
    why:
      got === undefined
        ? `After the fixed fields the data follows at once; its number of bytes, ${byteHex(expected)} (${expected}), belongs in front of it.`
        : `The byte count says ${byteHex(got)} (${got}). It should be ${byteHex(expected)} (${expected}).`,
    todo: 'Set the byte count to the number of data bytes behind it, and calculate the checksum after that.',
  }),
  'extra-bytes': ({ bytes }) => ({
    title: `${bytesOf(bytes)} too many inside`,
    why: `The frame is closed by its length or checksum, but ${bytesOf(bytes)} in it belong to no field of the function.`,
    todo: 'Leave them out, or correct quantity and byte count if they are data, and then length and checksum.',
  }),
  noise: ({ pattern, times }) => ({ title: 'No frame can be made out', ...NOISE[pattern](times) }),
  'ascii-line-end': ({ got }) => ({
    title: 'The line end is not CR LF',
    why: `The ASCII frame is whole and its LRC holds, but it ends with ${got === '' ? 'nothing' : (got.match(/../g) ?? []).join(' ')} instead of 0D 0A.`,
    todo: 'Send CR LF. Some terminals and languages send only one of them.',
  }),
  'hex-of-ascii-frame': ({ text, inMbap }) => ({
    title: inMbap ? 'ASCII characters inside a TCP frame' : 'Characters where bytes belong',
    why: inMbap
      ? `After the MBAP header come the characters “${visible(text)}”, not a function code and its data.`
      : `The bytes are the characters “${visible(text)}”: hexadecimal digits, not the bytes they stand for.`,
    todo: inMbap
      ? 'Set the serial side of the gateway to the mode of the devices, RTU or ASCII, so that it translates.'
      : 'If the line is RTU, send the bytes themselves, or set both sides to ASCII mode.',
  }),
  'other-protocol': ({ protocol, proof }) => ({
    title: `Not Modbus: this is ${OTHERS[protocol].is}`,
    why: `${OTHERS[protocol].marks}${proof === 'checksum' ? ', and its checksum holds' : ''}. In no transport of Modbus are the bytes a frame.`,
    todo: OTHERS[protocol].todo,
  }),
  envelope: ({ from, to, serial, holds, repaired }) => ({
    title: 'An RTU frame in a Solarman V5 envelope',
    why: `A data logger (serial number ${serial}) carries the frame over TCP: A5, a header, bytes ${from + 1} to ${to}, a sum and 15.${holds ? '' : ' The sum of the envelope is wrong.'}${repaired.length > 0 ? ' The frame inside is sound.' : ' The frame inside is not sound.'}`,
    todo: 'Read the frame inside. A program that talks to the logger must speak Solarman V5 on port 8899, not Modbus TCP on port 502.',
  }),
  'mbap-length': ({ got, expected, swapped }) => ({
    title: swapped ? 'The bytes of the MBAP length are swapped' : 'The MBAP length is wrong',
    why: `The length field says ${got}. The unit identifier and the PDU behind it have ${bytesOf(expected)}.`,
    todo: `Set the length to ${expected}, high byte first: it counts what follows it, from the unit identifier on.`,
  }),
};

const MOST_CHARACTERS = 40;
const visible = (text: string) =>
  text
    .slice(0, MOST_CHARACTERS)
    .replaceAll('\r', '\\r')
    .replaceAll('\n', '\\n')
    .concat(text.length > MOST_CHARACTERS ? '…' : '');
