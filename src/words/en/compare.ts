import type { Cause, CauseCode } from '../../diagnosis/index.ts';
import type { Transport } from '../../modbus/index.ts';
import { formatBytes, formatHex } from '../../notation/index.ts';
import { byteHex, bytesOf, code, fields, plural, word } from './common.ts';

/** What a difference most likely comes from, and what to do about it. */
export interface CauseWords {
  readonly why: string;
  /** Absent if there is nothing to do. */
  readonly todo?: string;
}

type Sentences<C extends CauseCode> = (cause: Extract<Cause, { code: C }>) => CauseWords;

const transports: Readonly<Record<Transport, string>> = {
  rtu: 'an RTU frame',
  ascii: 'an ASCII frame',
  tcp: 'a Modbus TCP frame',
  pdu: 'a bare PDU',
};

/** The bytes of a checksum as they are sent. */
const sent = ({ expected, algorithm }: { readonly expected: number; readonly algorithm: 'crc' | 'lrc' }) =>
  algorithm === 'lrc' ? byteHex(expected) : formatBytes(Uint8Array.of(expected & 0xff, expected >>> 8));

const name = ({ algorithm }: { readonly algorithm: 'crc' | 'lrc' }) => algorithm.toUpperCase();

const tables: Readonly<Record<number, string>> = {
  1: 'coils',
  2: 'discrete inputs',
  3: 'holding registers',
  4: 'input registers',
};

const table = (functionCode: number) => `function ${code(functionCode)} reads ${tables[functionCode] ?? 'others'}`;

const exceptions = fields.choices['exceptionCode'] ?? {};

const exceptionName = (exceptionCode = -1) => {
  const name = exceptions[exceptionCode]?.name;
  return name === undefined ? '' : `, ${byteHex(exceptionCode)} ${name}`;
};

const refusal = (exceptionCode = -1) => {
  const hint = exceptions[exceptionCode]?.hint;
  return `The device refused the request${hint === undefined ? '' : `: ${hint}`}.`;
};

/** “Built” is the current frame, “sent” the one it is compared with. */
const causes: { readonly [C in CauseCode]: Sentences<C> } = {
  identical: () => ({
    why: 'Every byte is the same.',
    todo: 'If there is still no answer, the bytes are not to blame: check wiring, speed, parity and the pause between frames.',
  }),
  'other-transport': ({ mine, theirs, same }) => ({
    why: `What was sent is ${transports[theirs]}; what was built is ${transports[mine]}.${same ? ' Unit, function and data are the same.' : ''}`,
    todo: `Set both sides to one transport, or choose the other transport in the form to compare byte by byte.`,
  }),
  'other-direction': ({ theirs }) => ({
    why:
      theirs === 'response'
        ? 'What was sent is a reply; what was built is a request.'
        : 'What was sent is a request; what was built is a reply.',
    todo: `Choose ${theirs === 'response' ? 'Reply' : 'Request'} in the form to compare like with like.`,
  }),
  'echo-of-request': () => ({
    why: 'What was sent is the request itself: an echo.',
    todo: 'The adapter hears its own sending. Switch its local echo off, or skip as many bytes as were sent.',
  }),
  'exception-instead': ({ whose, functionCode, exceptionCode }) => ({
    why: `${whose === 'theirs' ? 'What was sent' : 'What was built'} is an exception to function ${code(functionCode)}${exceptionName(exceptionCode)}; the other frame is not.`,
    ...(whose === 'theirs' && { todo: refusal(exceptionCode) }),
  }),
  'changed-after-checksum': () => ({
    why: 'The checksum sent is right for the frame built, but not for the bytes sent with it.',
    todo: 'The bytes were damaged on the way, or changed after the checksum was made. Send again; if the same bytes differ, look at the program.',
  }),
  'left-out': ({ mine, theirs }) => ({
    why: `No frame is this long: ${bytesOf(Math.max(mine, theirs))} at the end were not compared.`,
    todo: 'Paste one frame only.',
  }),
  'extra-before': ({ bytes }) => ({
    why: `${bytesOf(bytes)} came before the frame: noise when the line is switched on, or the end of the frame before.`,
    todo: 'Empty the receive buffer before each request, and check the biasing of the line.',
  }),
  'extra-after': ({ bytes }) => ({
    why: `${bytesOf(bytes)} came after the frame: noise when the line is switched off, or the beginning of the next frame.`,
    todo: 'Stop reading where the frame ends, and look at when the transmitter is switched off.',
  }),
  truncated: ({ missing }) => ({
    why: `The frame breaks off here: ${bytesOf(missing)} missing.`,
    todo: 'Read on until the frame is whole: a longer time-out, or a larger buffer.',
  }),
  'line-end-missing': () => ({
    why: 'The line does not end with CR LF.',
    todo: 'Send 0D 0A at the end. If the line was copied from a log, only the copy may lack it.',
  }),
  'bytes-missing': ({ bytes }) => ({
    why: `${bytesOf(bytes)} missing here.`,
    todo: 'Compare the program with the layout of this function. If it is another byte each time, bytes are lost on the way.',
  }),
  'bytes-inserted': ({ bytes }) => ({
    why: `${bytesOf(bytes)} too many here.`,
    todo: 'Compare the program with the layout of this function. If it is another byte each time, it is noise.',
  }),
  'bytes-swapped': () => ({
    why: 'The low byte is first. Modbus sends the high byte of a 16-bit number first.',
    todo: 'Swap the two bytes of each number on one side.',
  }),
  'words-swapped': () => ({
    why: 'The registers of each 32-bit value are the other way round: the low word is first.',
    todo: 'Swap the word order on one side. The specification does not say which is right.',
  }),
  'order-reversed': () => ({
    why: 'All four bytes of each 32-bit value are the other way round.',
    todo: 'Swap both the words and the bytes in them on one side.',
  }),
  'bits-reversed': () => ({
    why: 'The bits of each byte are the other way round. The first one belongs in the lowest bit.',
    todo: 'Reverse the bits of each byte on the side that puts the first one highest.',
  }),
  'decimal-as-hex': ({ mine, theirs, hex }) => {
    const digits = hex === 'theirs' ? mine : theirs;
    return {
      why: `The digits ${digits} are decimal for one side and hexadecimal for the other.`,
      todo: `Write the number meant as ${digits} in decimal, or as ${formatHex(digits, 1)}, on both sides.`,
    };
  },
  'lower-case-digits': () => ({
    why: 'The same value, written with lower-case digits. The specification has upper case only.',
    todo: 'Write A to F in upper case: some receivers refuse the others.',
  }),
  'value-differs': () => ({
    why: 'Another value.',
    todo: 'Set the value that is meant on both sides.',
  }),
  'content-differs': ({ different, of }) => ({
    why: of === 1 ? 'Another value.' : `${different} of ${of} values ${different === 1 ? 'is' : 'are'} not the same.`,
    todo: 'Set the values that are meant on both sides.',
  }),
  'length-differs': ({ mine, theirs }) => ({
    why: `${bytesOf(theirs)} of values were sent, ${bytesOf(mine)} built.`,
    todo: 'Ask for the same quantity on both sides.',
  }),
  'checksum-follows': () => ({
    why: 'Right on both sides: it differs only because bytes before it do.',
  }),
  'checksum-swapped': (check) => ({
    why: `The two bytes of the CRC are the other way round. It should be ${sent(check)}: the low byte is sent first.`,
    todo: 'Send the low byte of the CRC first, and then the high one.',
  }),
  'checksum-alone-wrong': (check) => ({
    why: `The ${name(check)} alone is wrong; the bytes before it are the same. It should be ${sent(check)}.`,
    todo: `Look at how the ${name(check)} is calculated: over which bytes, and from which initial value.`,
  }),
  'checksum-wrong': (check) => ({
    why: `The ${name(check)} sent does not hold for the bytes sent. It should be ${sent(check)}.`,
    todo: 'Damaged on the way, or calculated wrongly: the same bytes sent again tell which.',
  }),
  'my-checksum-wrong': (check) => ({
    why: `The ${name(check)} built is wrong. It should be ${sent(check)}.`,
    todo: 'Let the form calculate the checksum again.',
  }),
  'checksum-missing': () => ({
    why: 'No checksum was sent.',
    todo: 'Append it. Some tools leave it out of their logs: look at the line itself.',
  }),
  'unit-differs': () => ({
    why: 'Another unit: the frame is for, or from, another device.',
    todo: 'Set the same slave address on both sides.',
  }),
  'other-table': ({ mine, theirs }) => ({
    why: `Another table: ${table(theirs)}, ${table(mine)}. Manuals number input registers 3xxxx and holding registers 4xxxx.`,
    todo: 'Look up in which table the value is, and use its function.',
  }),
  'single-or-multiple': ({ mine, theirs }) => ({
    why: `Function ${code(Math.min(mine, theirs))} writes a single item, function ${code(Math.max(mine, theirs))} several; their layouts differ.`,
    todo: 'Use the one that the device knows. Some devices know only one of them.',
  }),
  'function-differs': ({ mine, theirs }) => ({
    why: `Function ${code(theirs)} was sent, ${code(mine)} built.`,
    todo: 'Set the same function on both sides.',
  }),
  'field-of-function': ({ functionCode }) => ({
    why: `This field belongs to function ${code(functionCode)} only.`,
  }),
  'address-off-by-one': () => ({
    why: 'One address apart: one side counts from 0, as the frame does, and the other from 1, as manuals do.',
    todo: 'Look up in the manual whether its first register is 0 or 1, and subtract 1 on one side only.',
  }),
  'entity-number': ({ number, address }) => ({
    why: `${number} is the number in the manual, not the address: the frame counts from 0 within its table.`,
    todo: `Send ${address} (${word(address)}).`,
  }),
  'address-differs': () => ({
    why: 'Another address.',
    todo: 'Look up the address in the manual, and whether it is printed in hexadecimal.',
  }),
  'quantity-doubled': ({ whose }) => ({
    why: `${whose === 'theirs' ? 'Sent' : 'Built'} is twice as many: bytes are counted, or each 32-bit value as two registers.`,
    todo: 'Count 16-bit registers, two of them for a 32-bit value.',
  }),
  'quantity-of-bytes': ({ whose }) => ({
    why: `${whose === 'theirs' ? 'Sent' : 'Built'} is the number of bytes that hold the bits.`,
    todo: 'Count bits, not bytes.',
  }),
  'quantity-differs': () => ({
    why: 'Another quantity.',
    todo: 'Ask for the same quantity on both sides.',
  }),
  'coil-value-illegal': ({ got }) => ({
    why: `${word(got)} is not a coil value. ON is FF 00, OFF is 00 00.`,
    todo: 'Send FF 00 for ON.',
  }),
  'coil-opposite': ({ theirs }) => ({
    why: `Sent is ${theirs === 0 ? 'OFF' : 'ON'}, built is ${theirs === 0 ? 'ON' : 'OFF'}.`,
    todo: 'Set the state that is meant on both sides.',
  }),
  'count-missing': () => ({
    why: 'The count is left out, so that every byte after it is read as something else.',
    todo: 'Send the count before what it counts.',
  }),
  'count-wrong': ({ got, expected }) => ({
    why: `Sent is ${got}, but the bytes sent with it make ${expected}.`,
    todo: `Send ${expected}.`,
  }),
  'count-of-registers': ({ got, expected }) => ({
    why: `Sent is ${got}, the number of registers; this count is of bytes.`,
    todo: `Send ${expected}, two bytes a register.`,
  }),
  'count-follows': () => ({
    why: 'Differs because what it counts does.',
  }),
  'transaction-differs': () => ({
    why: 'Another transaction: the reply repeats the number of its request, and each request has its own.',
    todo: 'Compare frames of one transaction. In a reply, repeat the number of the request.',
  }),
  'protocol-differs': () => ({
    why: 'The protocol identifier of Modbus is 0.',
    todo: 'Send 00 00.',
  }),
};

/** What a cause says, and what to do. */
function causeWords(cause: Cause): CauseWords {
  // Each code has the sentences of its own cause.
  const sentences = causes[cause.code] as (cause: Cause) => CauseWords;
  return sentences(cause);
}

/** What the comparison of two frames says. */
export const compare = {
  transports: 'The same frame in each transport',
  transportsHint: 'Unit and PDU stay the same; what carries them changes. ASCII writes each byte as two characters.',
  field: 'field',
  change: 'between them',
  stays: 'stays',
  changes: 'changes',
  /** In the place of a field that a transport does not have. */
  lacks: '–',
  size: (size: number, transport: Transport) => plural(size, transport === 'ascii' ? 'character' : 'byte'),
  notCarried: 'cannot carry it',
  current: 'current',
  copy: 'Copy',
  copyAs: (transport: string) => `Copy as ${transport}`,
  use: 'Use',
  useAs: (transport: string) => `Use as ${transport}`,
  heading: 'Compare with what was sent',
  sent: 'What your device sent',
  sentHint: 'Paste it as it is: bytes in any notation, or a line of a log. It stays here while the page is open.',
  notBytes: 'These are not bytes. Paste hexadecimal pairs (01 FF), or any other notation of bytes.',
  noFrame: 'Correct the frame above, and it is compared here.',
  identical: 'Identical',
  differences: (count: number) => (count === 0 ? 'Not of one kind' : plural(count, 'difference')),
  lines: 'Byte by byte: built above, sent below',
  built: 'Built',
  was: 'Sent',
  before: 'Before the frame',
  marks: { equal: '', different: 'differs', 'only-mine': 'missing', 'only-theirs': 'added' },
  gap: '––',
  none: 'nothing',
  list: 'Differences',
  causeWords,
};

export type CompareWords = typeof compare;
