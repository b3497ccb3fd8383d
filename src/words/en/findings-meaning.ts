import { byte, byteHex, bytesOf, code, plural, word } from './common.ts';
import { complaints } from './complaints.ts';
import { addressOf, unit, type WordsFor } from './finding-words.ts';

const CARRIED = { rtu: 'RTU', ascii: 'ASCII', tcp: 'TCP', pdu: 'PDU' } as const;

/** Why a device answers with each exception in practice, and what to check. */
const EXCEPTIONS: Readonly<Record<number, readonly [name: string, why: string, todo: string]>> = {
  1: [
    'ILLEGAL FUNCTION',
    'The device does not know this function, or does not allow it now.',
    "Look up which functions the device has. Many know 03 but not 04, or 16 (0x10) but not 06. A Modbus/TCP Security server also answers so where the client's role has no permission.",
  ],
  2: [
    'ILLEGAL DATA ADDRESS',
    'The address, or address plus quantity, reaches beyond what the device has.',
    'Check whether the manual counts from 1 where the frame counts from 0, whether 40001 was sent as an address, whether the quantity runs past the last register, and whether the value is in another table (03 or 04).',
  ],
  3: [
    'ILLEGAL DATA VALUE',
    'A quantity or a length is not allowed. Some devices also answer so for a value outside their own range.',
    'Ask for fewer registers at once, check the byte count, and read 32-bit values with both of their registers.',
  ],
  4: [
    'SERVER DEVICE FAILURE',
    'The device failed while it did what was asked.',
    "Look at the device's own state and error list. Some answer so for registers that cannot be read now.",
  ],
  5: [
    'ACKNOWLEDGE',
    'The device has accepted the request and needs long for it.',
    'Wait and ask again. Do not repeat the request.',
  ],
  6: [
    'SERVER DEVICE BUSY',
    'The device is busy with a long command.',
    'Send the request again later, and poll less often.',
  ],
  7: [
    'NEGATIVE ACKNOWLEDGE',
    'The device cannot carry out this programming command (old Modicon controllers).',
    "Look at the controller's error information.",
  ],
  8: [
    'MEMORY PARITY ERROR',
    "The device's file memory failed its check.",
    'Try again; if it persists, the device needs service.',
  ],
  10: [
    'GATEWAY PATH UNAVAILABLE',
    'The gateway has no way to this unit: it is not configured, or the gateway is overloaded.',
    'Check the unit identifier and the table of devices in the gateway.',
  ],
  11: [
    'GATEWAY TARGET DEVICE FAILED TO RESPOND',
    'The gateway asked the device and got no answer.',
    'Check the unit identifier, the wiring behind the gateway, the serial settings, and its time-out.',
  ],
};

/** Findings about what a frame says. */
export const meaning: WordsFor<
  | 'valid'
  | 'valid-exception'
  | 'valid-data'
  | 'unit-mismatch'
  | 'function-mismatch'
  | 'exception-of-other-function'
  | 'broadcast-answered'
  | 'coil-value-illegal'
  | 'padding-bits'
  | 'quantity-mismatch'
  | 'quantity-in-32-bit'
  | 'register-bytes-swapped'
  | 'address-is-number'
  | 'address-off-by-one'
  | 'function-of-other-table'
  | 'mbap-on-serial'
  | 'rtu-on-tcp'
  | 'rtu-on-ascii'
  | 'crc-on-tcp'
  | 'transaction-swapped'
  | 'transaction-mismatch'
  | 'rule-broken'
> = {
  valid: ({ transport, directions, functionCode, fields }) =>
    fields === 'fit'
      ? {
          title: 'Nothing is wrong with this frame',
          why: `It is a whole ${CARRIED[transport]} ${transport === 'pdu' ? '' : 'frame '}with function ${code(functionCode)}${directions.length === 1 ? `, a ${directions[0] === 'request' ? 'request' : 'reply'}` : '; request and reply look the same'}${transport === 'pdu' ? '' : transport === 'tcp' ? ', and its length is right' : ', and its checksum holds'}.`,
          todo: 'If it still does not work, look at the other side: unit, speed and parity, transport, and what the device answers.',
        }
      : {
          title: 'The CRC is right',
          why: `The last two bytes are the CRC of those before. As a frame of function ${code(functionCode)} there are too few bytes.`,
          todo: 'Add the fields that the function needs, and calculate the CRC again.',
        },
  'valid-exception': ({ functionCode, exceptionCode }) => {
    const [name, why, todo] = EXCEPTIONS[exceptionCode] ?? [
      'not defined',
      'The specification does not define this code.',
      "Look it up in the device's manual.",
    ];
    return {
      title: `The device refuses: exception ${byteHex(exceptionCode)}, ${name}`,
      why: `The frame is right: a refusal of function ${code(functionCode)}. ${why}`,
      todo,
    };
  },
  'valid-data': ({ registers, plausible }) => ({
    title: 'Contents of registers, not a frame',
    why: `No unit, function or checksum can be made out, but ${plural(registers, 'register')} with ${plausible === 'float' ? 'plausible 32-bit floats' : 'small numbers'} can.`,
    todo: 'Look at the values in each order of bytes and words.',
  }),
  'unit-mismatch': ({ got, expected }) => ({
    title: 'Another unit answers',
    why: `The reply is from unit ${unit(got)}; unit ${unit(expected)} was asked. The frame itself is right.`,
    todo: 'If the address of the device was just changed, ask the new one. Else look for a late reply to an earlier request, or two devices with one address.',
  }),
  'function-mismatch': ({ got, expected }) => ({
    title: 'The reply is to another function',
    why: `The reply has function ${code(got)}; ${code(expected)} was asked.`,
    todo: 'It is probably the late reply to an earlier request: empty the receive buffer, and lengthen the time-out.',
  }),
  'exception-of-other-function': ({ got, expected, exceptionCode }) => ({
    title: 'A refusal of another function',
    why: `Exception ${byteHex(exceptionCode)} refuses function ${code(got)}, but ${code(expected)} was asked.`,
    todo: "It is a late reply to an earlier request, or a fault of the device's program: it must set the high bit of the function it was asked for.",
  }),
  'broadcast-answered': () => ({
    title: 'A broadcast was answered',
    why: 'The request was for unit 0, all devices. No device may answer it: on a line with several devices all would answer at once.',
    todo: 'Ask the device by its own address. If it answers to 0 only, set its address first.',
  }),
  'coil-value-illegal': ({ got }) => ({
    title: `${word(got)} is not a coil value`,
    why: 'A coil is written with FF00 for ON or 0000 for OFF. Anything else has no effect, and correct devices refuse it with exception 03.',
    todo:
      got === 0x0001 || got === 0x00ff
        ? 'Send FF 00 for ON: the value is in the high byte.'
        : 'Send FF 00 for ON or 00 00 for OFF.',
  }),
  'padding-bits': ({ quantity, got }) => ({
    title: 'Bits are set beyond the quantity',
    why: `${plural(quantity, 'coil')} are written, but in the last byte higher bits are set as well (${byte(got)} above the last coil). They should be zero.`,
    todo: 'Set the unused high bits to zero, or the quantity to what you mean.',
  }),
  'quantity-mismatch': ({ got, expected }) => ({
    title: 'The reply has another length than was asked for',
    why: `The reply has ${bytesOf(got)} of data; the request asked for ${expected}.`,
    todo: 'It may be the late reply to another request, or a device that does not have all that was asked for.',
  }),
  'quantity-in-32-bit': ({ got, expected }) => ({
    title: 'Values of 32 bits, counted as 16',
    why: `The reply has ${bytesOf(got)}: ${plural(got / 2, 'register')}, or ${plural(got / 4, 'value')} of 32 bits. For as many 32-bit values as registers there would be ${expected}.`,
    todo: 'A quantity always counts 16-bit registers: ask for two for each 32-bit value.',
  }),
  'register-bytes-swapped': ({ got, swapped }) => ({
    title: 'The bytes of the registers look swapped',
    why: `The first value is ${got} (${word(got)}); with its bytes exchanged it is ${swapped} (${word(swapped)}).`,
    todo: 'Modbus sends the high byte first. If the exchanged value makes sense, the device sends the low one first: exchange them after reading.',
  }),
  'address-is-number': ({ number, address }) => ({
    title: `${number} may have been sent as an address`,
    why: `In manuals ${number} is the number of an element: its first digit names the table, and numbers begin with 1. In the frame it has address ${addressOf(address)}.`,
    todo: `Try address ${addressOf(address)}. Some devices do have addresses this high.`,
  }),
  'address-off-by-one': ({ got, expected }) => ({
    title: 'The address may be off by one',
    why: `The frame has address ${addressOf(got)}. Addresses in frames begin with 0, numbers in manuals with 1.`,
    todo: `Try address ${addressOf(expected)}.`,
  }),
  'function-of-other-table': ({ functionCode, meant, number }) => ({
    title: 'The value may be in another table',
    why:
      number === undefined
        ? `Function ${code(functionCode)} reads one table, ${code(meant)} another. The same address can be there in one and not in the other.`
        : `${number} is a number of the table that function ${code(meant)} reads; this request has function ${code(functionCode)}.`,
    todo: `Try function ${code(meant)}${number === undefined ? ' with the same address' : ''}.`,
  }),
  'mbap-on-serial': ({ transactionId }) => ({
    title: 'A TCP frame on a serial line',
    why: `The bytes begin with an MBAP header (transaction ${transactionId}) and have no serial checksum. A serial line has unit, PDU and checksum only.`,
    todo: 'Set the program to RTU, or to RTU over TCP where it speaks to a plain serial server.',
  }),
  'rtu-on-tcp': () => ({
    title: 'An RTU frame on a TCP connection',
    why: 'The bytes are a whole RTU frame with its CRC. Modbus TCP has an MBAP header in front and no CRC.',
    todo: 'Set both sides to the same: Modbus TCP, or RTU over TCP.',
  }),
  'rtu-on-ascii': () => ({
    title: 'An RTU frame where ASCII is spoken',
    why: 'The bytes are a whole RTU frame with its CRC, not characters from a colon to CR LF.',
    todo: 'Set both sides to the same mode. RTU is the usual one.',
  }),
  'crc-on-tcp': () => ({
    title: 'A CRC behind a TCP frame',
    why: 'The last two bytes are a CRC. With the MBAP header in front there is none: TCP has its own checksums.',
    todo: 'Leave the CRC out, and do not count it in the length.',
  }),
  'transaction-swapped': ({ got, expected }) => ({
    title: 'The bytes of the transaction identifier are swapped',
    why: `The reply has ${word(got)}; the request has ${word(expected)}.`,
    todo: 'The server must return both bytes as they came. Read and write the header high byte first.',
  }),
  'transaction-mismatch': ({ got, expected }) => ({
    title: 'The reply belongs to another transaction',
    why: `The reply has transaction ${got} (${word(got)}); the request has ${expected} (${word(expected)}).`,
    todo: 'It may be a late reply: discard it and read on. Some servers always answer with the same number; clients must then ask one at a time.',
  }),
  'rule-broken': ({ problem }) => ({
    title: 'A rule of the specification is broken',
    cause: complaints.problem(problem),
    why: `The frame is whole, but ${lowerFirst(complaints.problem(problem))}`,
    todo: `See ${problem.section}. Correct devices refuse this frame or ignore it.`,
  }),
};

const lowerFirst = (text: string) => `${text.charAt(0).toLowerCase()}${text.slice(1)}`;
