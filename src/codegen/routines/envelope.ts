import { hexDigits, MBAP, MOST_ASCII, MOST_RTU, MOST_TCP, type Transport } from '../../modbus/index.ts';
import { type Argument, binary, convert, type Expression, element, int, type Name, type Statement } from '../code.ts';
import { array, byte, call, highByte, lowByte, name, plus, put, type Remarks, times } from './terms.ts';

/** How the bytes of a frame stand in what is sent: places are counted in bytes from the unit, or from the MBAP header of TCP. */
export interface Envelope {
  readonly transport: Transport;
  /** Where the function code stands. The unit stands before it. */
  readonly code: number;
  /** Bytes behind the PDU. */
  readonly tail: number;
  /** Most bytes, or characters, of a frame. */
  readonly most: number;
  /** Fewest bytes, or characters, of a frame that has a function code. */
  readonly least: number;
  /** The byte at a place of a frame. */
  byteAt(frame: Name, at: Expression): Expression;
  /** How many bytes there are, by the length of what was received. */
  bytesIn(length: Expression): Expression;
  /** What a number of bytes takes. */
  lengthOf(bytes: Expression): Expression;
  /** Puts a byte. */
  put(value: Expression, remarks?: Remarks): readonly Statement[];
  /** What begins and ends a frame of known length; `transaction` of TCP. */
  head(pduBytes: number, transaction: Expression): readonly Statement[];
  readonly end: readonly Statement[];
}

const frame: Argument = array('frame');
const soFar: Expression = { kind: 'put so far', type: 'int' };

const binaryFrame = {
  byteAt: (of: Name, at: Expression) => element('byte', of, at),
  bytesIn: (length: Expression) => length,
  lengthOf: (bytes: Expression) => bytes,
  put: (value: Expression, remarks: Remarks = {}) => [put(value, remarks)],
} as const;

const rtu: Envelope = {
  ...binaryFrame,
  transport: 'rtu',
  code: 1,
  tail: 2,
  most: MOST_RTU,
  least: 4,
  head: () => [],
  end: [
    { kind: 'declare', name: 'checksum', value: call('word', 'crc', frame, soFar), changes: false },
    put(lowByte(name('word', 'checksum')), { spans: ['checksum'], comment: 'CRC, low byte' }),
    put(highByte(name('word', 'checksum')), { spans: ['checksum'], comment: 'CRC, high byte' }),
  ],
};

const tcp: Envelope = {
  ...binaryFrame,
  transport: 'tcp',
  code: MBAP,
  tail: 0,
  most: MOST_TCP,
  least: MBAP + 1,
  head: (pduBytes, transaction) => [
    put(highByte(transaction), { spans: ['transactionId'], comment: 'transaction, high byte' }),
    put(lowByte(transaction), { spans: ['transactionId'], comment: 'transaction, low byte' }),
    put(byte(0), { spans: ['protocolId'], comment: 'protocol: 0 is Modbus' }),
    put(byte(0), { spans: ['protocolId'] }),
    put(byte((pduBytes + 1) >> 8), { spans: ['length'], comment: `length: ${pduBytes + 1} bytes follow` }),
    put(byte((pduBytes + 1) & 0xff), { spans: ['length'] }),
  ],
  end: [],
};

/** What begins and ends an ASCII frame. */
export const asciiCharacters = { colon: 0x3a, cr: 0x0d, lf: 0x0a } as const;
const { colon: COLON, cr: CR, lf: LF } = asciiCharacters;

const digit = (value: Expression): Expression => call('byte', 'digit of', value);

const putDigits = (value: Expression, remarks: Remarks = {}): readonly Statement[] => {
  const whole = convert('int', value);
  if (value.kind === 'number') {
    const [high = 0, low = 0] = Array.from(hexDigits(value.value, 2), (character) => character.charCodeAt(0));
    return [put(byte(high), remarks), put(byte(low), { spans: remarks.spans })];
  }
  return [
    put(digit(binary(whole, '/', int(16))), remarks),
    put(digit(binary(whole, '%', int(16))), { spans: remarks.spans }),
  ];
};

const ascii: Envelope = {
  transport: 'ascii',
  code: 1,
  tail: 1,
  most: MOST_ASCII,
  // Colon, unit, function, LRC, CR LF.
  least: 9,
  byteAt: (of, at) => call('byte', 'byte of digits', array(of), plus(times(2, at), int(1))),
  bytesIn: (length) => binary(binary(length, '-', int(3)), '/', int(2)),
  lengthOf: (bytes) => plus(times(2, bytes), int(3)),
  put: putDigits,
  head: () => [put(byte(COLON), { spans: ['start'], comment: 'colon' })],
  end: [
    { kind: 'declare', name: 'checksum', value: call('byte', 'lrc', frame, soFar), changes: false },
    ...putDigits(name('byte', 'checksum'), { spans: ['checksum'], comment: 'LRC' }),
    put(byte(CR), { spans: ['end'], comment: 'CR LF' }),
    put(byte(LF), { spans: ['end'] }),
  ],
};

const pdu: Envelope = { ...rtu, transport: 'pdu', code: 0, tail: 0, least: 1, end: [] };

export const envelopes: Readonly<Record<Transport, Envelope>> = { rtu, ascii, tcp, pdu };
