import { LAST_ADDRESS, type Problem, type ProblemCode } from '../../modbus/index.ts';
import { formatBytes, formatHex } from '../../notation/index.ts';
import type { InputError, InputReason } from '../../workbench/index.ts';
import { addressIn, byte, byteHex, bytesOf, code, fields, word } from './common.ts';

type Sentence<C extends ProblemCode> = (problem: Extract<Problem, { code: C }>) => string;

/** What each problem says, one sentence or two: what is wrong here, and what is legal. */
const problems: { readonly [C in ProblemCode]: Sentence<C> } = {
  'frame-short': ({ missing }) => `The frame is incomplete: at least ${bytesOf(missing)} must still come.`,
  'frame-extra': ({ bytes }) => `The frame ends before this: ${bytesOf(bytes)} too many.`,
  'pdu-short': ({ missing }) => `The frame ends here, but the function's fields need ${bytesOf(missing)} more.`,
  'pdu-rest': ({ bytes }) => `No field of this function takes ${bytes === 1 ? 'this byte' : `these ${bytes} bytes`}.`,
  'pdu-too-long': ({ got, most }) =>
    `The PDU has ${got} bytes. At most ${most} are allowed: 256 bytes in an RTU frame, 513 characters in ASCII, 260 bytes over TCP.`,
  'checksum-wrong': ({ algorithm, got, expected }) =>
    algorithm === 'crc'
      ? `The CRC does not hold: the bytes before it give ${word(expected)}, sent ${wire(expected)}; the frame has ${wire(got)}.`
      : `The LRC does not hold: the bytes before it give ${byteHex(expected)}; the frame has ${byteHex(got)}.`,
  'mbap-length-wrong': ({ got, expected }) =>
    `The length field says ${got}, but the unit identifier and the PDU have ${bytesOf(expected)}.`,
  'mbap-length-out-of-range': ({ got, least, most }) =>
    `The length field says ${got}. It counts the unit identifier and the PDU: ${least} to ${most} bytes.`,
  'protocol-id-not-zero': ({ got }) => `The protocol identifier is ${word(got)}. Modbus is 0x0000.`,
  'ascii-start': () => 'An ASCII frame starts with a colon, 3A.',
  'ascii-end': ({ got }) =>
    got.startsWith('0D')
      ? `The frame ends with CR and ${got.slice(2)} instead of LF. That is right only after function 08, sub-function 03 has changed the delimiter.`
      : `The frame ends with ${got || 'nothing'}. It must be CR LF, 0D 0A.`,
  'ascii-character': ({ got }) =>
    `Character ${byteHex(got)}${got > 0x20 && got < 0x7f ? ` (${String.fromCharCode(got)})` : ''} is not a hexadecimal digit. Only 0–9 and A–F are allowed between the colon and CR LF.`,
  'ascii-lower-case': ({ got }) =>
    `“${String.fromCharCode(got)}” is a lower-case digit. The specification has 0–9 and A–F only; lenient receivers take it.`,
  'ascii-odd-digit': ({ got }) => `${got} digits: each byte takes two, so one digit is missing or too many.`,
  'unit-reserved': ({ got }) => `Unit ${got} is reserved on a serial line. Devices have 1 to 247.`,
  'unit-unspecified': ({ got }) =>
    `Unit ${got} has no agreed meaning on TCP: 255 is the server itself, 1 to 247 a device behind a gateway.`,
  'unit-zero-on-tcp': () =>
    'Unit 0 on TCP: accepted for a server that is reached directly, though 255 is preferred. Behind a gateway it is a broadcast on the serial line.',
  'broadcast-not-agreed': ({ functionCode }) =>
    `Function ${code(functionCode)} to unit 0: no broadcast is agreed for it. Broadcasts are for ${[5, 6, 15, 16].map(code).join(', ')}.`,
  'reply-from-broadcast': () => 'A reply from unit 0: no device answers a broadcast, and none has address 0.',
  'function-zero': () => 'Function code 0 is not valid. Codes are 1 to 127; 128 and above are exceptions.',
  'function-above-127': ({ got }) =>
    `Function code ${byte(got)} is in the range of exception replies, 128 to 255. No request has such a code.`,
  'function-reserved': ({ got, vendor }) =>
    `Function code ${byte(got)} is reserved${vendor ? `; in the field it is ${vendor}` : ''}. What follows is shown as raw data.`,
  'function-user-defined': ({ got, vendor }) =>
    `Function code ${byte(got)} is one of the user-defined ones, 65 to 72 and 100 to 110${vendor ? `; in the field it is ${vendor}` : ''}. What follows is shown as raw data.`,
  'function-unassigned': ({ got }) =>
    `Function code ${byte(got)} is not assigned to any function. What follows is shown as raw data.`,
  'function-serial-only': ({ functionCode }) =>
    `Function ${code(functionCode)} is for serial lines only; a TCP server need not know it.`,
  'mei-type-reserved': ({ got }) => `MEI type ${byte(got)} is reserved. In use are 0x0D and 0x0E.`,
  'sub-function-reserved': ({ got }) => `Sub-function ${word(got)} is reserved.`,
  'sub-function-without-reply': ({ got }) =>
    `Sub-function ${word(got)} has no reply: the device goes silent, so no correct device sends this.`,
  'no-reply-in-listen-only': () => 'A device in listen only mode restarts without sending this reply.',
  'exception-undefined': ({ got }) =>
    `Exception code ${byte(got)} is not defined. Defined are 01 to 06, 08, 0A and 0B.`,
  'exception-pi-only': () =>
    'Exception code 07 is defined only in the older Modicon reference guide, for programming functions.',
  'quantity-out-of-range': ({ got, least, most }) => `The quantity is ${got}. Legal are ${least} to ${most}.`,
  'address-range-over-end': ({ address, quantity }) =>
    `${quantity} from address ${addressIn(address)} would end at ${address + quantity - 1}. The last address is ${addressIn(LAST_ADDRESS)}.`,
  'value-out-of-range': ({ got, least, most }) => `${got} is not allowed. Legal are ${least} to ${most}.`,
  'value-not-allowed': ({ got, allowed }) =>
    `${formatHex(got, 2)} is not allowed. Legal ${allowed.length === 1 ? 'is' : 'are'} ${allowed.map((value) => formatHex(value, value > 0xff ? 4 : 2)).join(', ')}.`,
  'coil-value-illegal': ({ got }) =>
    `${word(got)} is not a coil value and has no effect. Legal are 0xFF00 for ON and 0x0000 for OFF; some devices take anything but 0 as ON.`,
  'padding-not-zero': () => 'The unused high bits of the last byte are not zero, as they should be.',
  'data-not-allowed': ({ got, allowed }) =>
    `The data is ${got}. For this sub-function it must be ${allowed.join(' or ')}.`,
  'data-length': ({ got, expected }) => `This sub-function has ${bytesOf(expected)} of data, not ${got}.`,
  'data-length-odd': ({ got }) => `The data is made of 16-bit words, but has ${bytesOf(got)}.`,
  'diagnostics-length-open': ({ got }) =>
    `${bytesOf(got)} of data: any number of words is allowed, but no byte tells how many, and many devices take exactly two bytes.`,
  'old-controller-limit': ({ got, limit }) => `${got} is legal, but old Modicon controllers take at most ${limit}.`,
  'file-number-high': ({ got }) => `File ${got}: numbers above 10 are legal, but older devices may not know them.`,
  'reply-too-long': ({ got, most }) => `The reply would need a PDU of ${got} bytes; at most ${most} are possible.`,
  'object-id-reserved': ({ got }) =>
    `Object ${byte(got)} is reserved. 00 to 06 have names, 80 to FF are the maker's own.`,
  'next-object-not-zero': ({ got }) => `The next object id is ${byte(got)}, but nothing more follows: it must be 00.`,
  'object-count-differs': ({ got, expected }) =>
    `The number of objects is ${got}, but the reply has ${expected}. The text of the specification counts the objects of this reply, its example those of the whole stream.`,
  'server-id-layout-open': () =>
    'The maker decides what these bytes mean. A server id, a run indicator (FF on, 00 off) and more are usual, but no byte tells how long the id is.',
  'count-out-of-range': ({ got, least, most }) => `This count is ${got}. Legal are ${least} to ${most}.`,
  'count-odd': ({ got }) => `A byte count of ${got} is odd. Registers have two bytes each.`,
  'count-contradicts-quantity': ({ got, expected, quantity }) =>
    `The byte count is ${got}, but a quantity of ${quantity} needs ${expected}.`,
  'count-wrong': ({ got, expected }) => `This says ${got}, but by the bytes that are here it would be ${expected}.`,
  'count-table-differs': ({ got, least, most }) =>
    `${got} is possible, though a table of the specification says ${least} to ${most}; it contradicts itself here.`,
  'unit-not-as-requested': ({ got, expected }) => `Unit ${got} answers, but unit ${expected} was asked.`,
  'transaction-not-as-requested': ({ got, expected }) => `Transaction ${got} does not answer transaction ${expected}.`,
  'function-not-as-requested': ({ got, expected }) =>
    `A reply to function ${code(got)}, but function ${code(expected)} was asked.`,
  'count-not-as-requested': ({ got, expected }) => `The byte count is ${got}, but the request asked for ${expected}.`,
  'echo-differs': ({ field }) => `${fields.labels[field] ?? field} is not as in the request, which this reply repeats.`,
  'broadcast-answered': () => 'The request was a broadcast: no device answers it.',
};

const wire = (crc: number) => formatBytes(Uint8Array.of(crc & 0xff, crc >>> 8));

/** What is wrong with an input, and what would do. */
function inputError(error: InputError): string {
  const sentence = reasonWords(error);
  return error.index === undefined ? sentence : `Item ${error.index + 1}: ${sentence}`;
}

function reasonWords(reason: InputReason): string {
  switch (reason.code) {
    case 'field-missing':
      return 'Type a value.';
    case 'number-out-of-range': {
      const digits = reason.most > 0xff ? 4 : 2;
      const got = reason.got === Number.POSITIVE_INFINITY ? 'So large a number' : String(reason.got);
      return `${got} does not fit: whole numbers from ${reason.least} to ${reason.most} (${formatHex(reason.least, digits)} to ${formatHex(reason.most, digits)}).`;
    }
    case 'not-a-number':
      return `“${reason.text}” is not a number. Write decimal 683 or hexadecimal 0x2AB, 2ABh or 16#2AB.`;
    case 'unit-without-device':
      return `“${reason.text}”: choose a device, or say what full scale is. Nothing here says how ${reason.unit} stand in the register.`;
    case 'not-an-address':
      return `“${reason.text}” is not an address. Write it from 0, 683 or 0x2AB, or as manuals do: 4x684, 400684, HR684, %MW683. Numbers end at 65536. The names of a device are read while it is chosen.`;
    case 'not-a-time':
      return `“${reason.text}” is not a time of at most an hour. Write 5 ms, 750 us, 1.5 s, 20 bits or 2 characters.`;
    case 'not-a-bit':
      return `“${reason.text}” is not a bit. Write 0 and 1, or on and off.`;
    case 'not-octets':
      return `“${reason.text}” is neither hexadecimal pairs (01 FF) nor text in quotes ("PLC").`;
    case 'not-a-flag':
      return 'Choose ON or OFF.';
    case 'not-a-list':
      return 'Type a list.';
    case 'not-hex':
      return 'Write hexadecimal pairs, such as 01 FF.';
    case 'not-ascii':
      return 'Only ASCII characters fit here.';
  }
}

/** The sentences about what is wrong, each without its section. */
export const complaints = {
  problem: (problem: Problem): string => (problems[problem.code] as (problem: Problem) => string)(problem),
  inputError,
};
export type Complaints = typeof complaints;
