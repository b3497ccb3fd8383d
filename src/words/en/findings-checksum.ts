import type { MisprintedFrameId } from '../../diagnosis/index.ts';
import { formatBytes } from '../../notation/index.ts';
import { byte, byteHex, bytesOf, word } from './common.ts';
import { type WordsFor, wire } from './finding-words.ts';

const SEND = (expected: number) => `Send ${wire(expected)} at the end.`;
const ONLY_REST = 'The rest of the frame fits its function.';

const OF_FRAME = {
  request: 'the request that this answers',
  reply: 'the reply to this request',
  exception: 'an exception reply to this request',
  shorter: 'this frame with fewer values in it',
  longer: 'this frame with zeros behind its values',
} as const;

const MISPRINTED: Readonly<Record<MisprintedFrameId, string>> = {
  'weg-set-30-hz': 'the WEG guide’s frame that sets 30 Hz',
  'weg-run': 'the WEG guide’s frame that starts the motor',
  'weg-stop': 'the WEG guide’s frame that stops the motor',
  'weg-read-speed': 'the WEG guide’s frame that reads the speed',
  'introduction-read-40108': 'the introduction’s request for registers 40108 to 40110',
};

/** What prints them. */
const SOURCES: Readonly<Record<MisprintedFrameId, string>> = {
  'weg-set-30-hz': 'The WEG guide',
  'weg-run': 'The WEG guide',
  'weg-stop': 'The WEG guide',
  'weg-read-speed': 'The WEG guide',
  'introduction-read-40108': 'The introduction',
};

const swap = (crc: number) => ((crc & 0xff) << 8) | (crc >>> 8);

const ELSE = {
  exception: 'an exception: the function code with its high bit set, and an exception code',
  'line-end': 'a line end (CR LF), as at the end of an ASCII frame',
  ones: 'ones only, as memory that was never written',
  length: 'the number of bytes',
  'last-data': 'the last register once more',
  lrc: 'the LRC, the checksum of ASCII frames',
} as const;

/** Findings about the checksum. */
export const checksum: WordsFor<
  | 'crc-byte-order'
  | 'crc-of-text'
  | 'crc-algorithm'
  | 'crc-start-value'
  | 'crc-span'
  | 'crc-of-other-frame'
  | 'crc-is-something-else'
  | 'crc-missing'
  | 'lrc-instead-of-crc'
  | 'crc-instead-of-lrc'
  | 'bit-error'
  | 'byte-error'
  | 'byte-inserted'
  | 'byte-lost'
  | 'known-misprint'
  | 'crc-wrong'
  | 'lrc-wrong'
  | 'lrc-missing'
> = {
  'crc-byte-order': ({ got, expected }) => ({
    title: 'The CRC bytes are swapped',
    why: `The CRC of these bytes is the number ${word(expected)}. On the wire its low byte goes first: ${wire(expected)}. The frame has ${wire(got)}.`,
    todo: `${SEND(expected)} Many calculators show the number, not the order of sending.`,
  }),
  'crc-of-text': ({ got, expected, text }) => ({
    title: 'The CRC is that of the text, not of the bytes',
    why: `${wire(got)} is the CRC of the ${text.length} characters “${shorten(text)}”. The bytes they stand for have the CRC ${wire(expected)}.`,
    todo: `Set the calculator's input to hexadecimal. ${SEND(expected)}`,
  }),
  'crc-algorithm': ({ expected, algorithm, swapped }) => ({
    title: `The checksum is ${algorithm}`,
    why: `The bytes at the end are the ${algorithm} of the frame${swapped ? ', high byte first' : ''}. Modbus RTU uses CRC-16/MODBUS: polynomial 8005 reflected, start value FFFF, which gives ${wire(expected)}.`,
    todo: `Choose CRC-16/MODBUS in the program or calculator. ${SEND(expected)}`,
  }),
  'crc-start-value': ({ got, expected, start }) => ({
    title: `The CRC began with ${word(start)}`,
    why: `${wire(got)} is what comes out if the register begins with ${word(start)}. It must begin with 0xFFFF, which gives ${wire(expected)}.`,
    todo: `Set the register to 0xFFFF before the first byte of each frame. ${SEND(expected)}`,
  }),
  'crc-span': ({ got, expected, over, first, last }) => ({
    title: 'The CRC is taken over the wrong bytes',
    why: `${wire(got)} is the CRC ${OVER[over](first, last)}. It belongs over all bytes from the unit identifier to the last data byte: ${wire(expected)}.`,
    todo: `Begin with the unit identifier and stop before the CRC. ${SEND(expected)}`,
  }),
  'crc-of-other-frame': ({ got, expected, of }) => ({
    title: 'The CRC belongs to another frame',
    why: `${wire(got)} is the CRC of ${OF_FRAME[of]}. These bytes have ${wire(expected)}.`,
    todo: `Calculate the CRC again for each frame, after its last byte is set. ${SEND(expected)}`,
  }),
  'crc-is-something-else': ({ got, expected, as }) => ({
    title: 'Something else is in the place of the CRC',
    why: `The last two bytes, ${wire(got)}, are ${ELSE[as]}. The CRC of the bytes before them is ${wire(expected)}.`,
    todo: SEND(expected),
  }),
  'crc-missing': ({ zero, expected }) => ({
    title: 'The CRC is missing',
    why: zero
      ? `The place of the CRC holds 00 00. It was never calculated; it should be ${wire(expected)}.`
      : `The bytes end just where the CRC belongs. It should be ${wire(expected)}.`,
    todo: zero
      ? `${SEND(expected)} Devices that always send 00 00 do not follow the specification; a client must be told to ignore the CRC.`
      : `${SEND(expected)} If a log shows these bytes, it may leave the CRC out.`,
  }),
  'lrc-instead-of-crc': ({ got, expected }) => ({
    title: 'An LRC is where the CRC belongs',
    why: `${byteHex(got)} is the LRC, the checksum of ASCII frames. An RTU frame ends with a CRC of two bytes: ${wire(expected)}.`,
    todo: `Set the sender to RTU instead of ASCII, or send ${wire(expected)} instead of ${byteHex(got)}.`,
  }),
  'crc-instead-of-lrc': ({ got, expected }) => ({
    title: 'A CRC is where the LRC belongs',
    why: `${wire(got)} is the CRC of an RTU frame. An ASCII frame ends with an LRC of one byte: ${byteHex(expected)}.`,
    todo: `Set the sender's checksum to LRC, or the line to RTU. Here ${byteHex(expected)} belongs before CR LF.`,
  }),
  'bit-error': ({ at, bit, got, expected }) => ({
    title: `One bit of byte ${at + 1} is wrong`,
    why: `With ${byteHex(expected)} instead of ${byteHex(got)} as byte ${at + 1} (bit ${bit} the other way), the CRC holds.`,
    todo: 'Single wrong bits come from the line: check termination, shielding, ground, and that both sides have the same speed.',
  }),
  'byte-error': ({ at, got, expected, others }) => ({
    title: `Byte ${at + 1} is probably wrong`,
    why: `With ${byteHex(expected)} instead of ${byteHex(got)} as byte ${at + 1}, the CRC holds.${others > 0 ? ` A change of one byte elsewhere would do as well (${others} more).` : ''}`,
    todo: 'If the frame was edited by hand, calculate the CRC again. If it was received, look for disturbance on the line.',
  }),
  'byte-inserted': ({ at, got }) => ({
    title: `Byte ${at + 1} is one too many`,
    why: `Without ${byte(got)} at byte ${at + 1} the frame is whole and its CRC holds.`,
    todo: 'Look for what adds it: a text mode that turns 0A into 0D 0A, an escape, or two senders at once.',
  }),
  'byte-lost': ({ at, lost }) => ({
    title: `A byte was lost before byte ${at + 1}`,
    why: `With ${byte(lost)} in front of byte ${at + 1} the frame is whole and its CRC holds.`,
    todo: 'Look for what swallows it: a string that ends at 00, a text mode (0D, 0A), software flow control (11, 13).',
  }),
  'known-misprint': ({ misprint, wrong, swapped, got, expected, repaired }) => ({
    title:
      wrong === 'crc'
        ? `A known misprint: ${MISPRINTED[misprint]}`
        : `Perhaps a known misprint: ${MISPRINTED[misprint]}`,
    why:
      wrong === 'crc'
        ? `The source prints these bytes${swapped ? ' with the CRC the other way round' : ''}, but they have the CRC ${wire(expected)}, not ${wire(got)}.`
        : `The source prints these bytes, but the address it means has ${byteHex(expected)} where ${byteHex(got)} stands.`,
    ...(wrong === 'crc' && {
      cause: `${SOURCES[misprint]} prints ${wire(swapped ? swap(got) : got)} for this frame${swapped ? ', here with its bytes swapped' : ''}; that is a misprint. The CRC is ${wire(expected)}.`,
    }),
    todo: `Send ${formatBytes(repaired[0] ?? new Uint8Array())}.`,
  }),
  'crc-wrong': ({ got, expected }) => ({
    title: 'The CRC is wrong',
    cause: `The CRC of these bytes is ${wire(expected)}; none of the usual mistakes gives ${wire(got)}.`,
    why: `These bytes have the CRC ${wire(expected)}; the frame has ${wire(got)}. None of the usual mistakes explains it: swapped bytes, another algorithm or start value, other bytes covered, the CRC of the text, or a single wrong bit.`,
    todo: `If you send this frame, end it with ${wire(expected)}. If it was printed, it may be a misprint. If it was received, more than one byte was disturbed.`,
  }),
  'lrc-missing': ({ expected }) => ({
    title: 'The LRC is missing',
    why: `The fields end where the line does. Before CR LF the LRC belongs: ${byteHex(expected)}.`,
    todo: `Send ${byteHex(expected)} before CR LF.`,
  }),
  'lrc-wrong': ({ got, expected }) => ({
    title: 'The LRC is wrong',
    cause: `The LRC of these bytes is ${byteHex(expected)}.`,
    why: `These bytes have the LRC ${byteHex(expected)}; the frame has ${byteHex(got)}. ${ONLY_REST}`,
    todo: `Send ${byteHex(expected)} before CR LF. It is the two's complement of the sum of the bytes, not of the characters.`,
  }),
};

const OVER = {
  part: (first: number, last: number) =>
    last - first === 1 ? `of byte ${first + 1} alone` : `of bytes ${first + 1} to ${last} only`,
  'with-checksum': () => 'of the frame with room for the checksum behind it',
  'with-length': (_first: number, last: number) => `of a length byte and the ${bytesOf(last)} after it`,
  'with-mbap': () => 'of the frame with an MBAP header in front, as on TCP',
} as const;

const MOST_CHARACTERS = 48;
const shorten = (text: string) =>
  (text.length > MOST_CHARACTERS ? `${text.slice(0, MOST_CHARACTERS)}…` : text).trimEnd();
