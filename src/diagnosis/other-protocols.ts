import { sumOf, word } from './frames.ts';

/** A protocol that people meet on the same lines and paste as if it were Modbus. */
export type OtherProtocol =
  | 'daly'
  | 'jk-bms'
  | 'jbd-bms'
  | 'pylontech'
  | 'dl-t-645'
  | 'sml'
  | 'm-bus'
  | 'nmea'
  | 'text';

/** What shows that bytes are of another protocol, and the evidence in bits that chance did not make them so. */
export interface Recognized {
  readonly protocol: OtherProtocol;
  /** Its checksum holds, its marks and lengths stand where they belong, or all bytes are characters. */
  readonly proof: 'checksum' | 'shape' | 'characters';
  readonly bits: number;
}

type Recognizer = (bytes: Uint8Array) => Recognized | undefined;

const at = (bytes: Uint8Array, index: number): number => bytes[index] ?? -1;

/** Daly's battery protocol over UART: A5, address, 90…98 or another command, 08, eight bytes of data, their sum. */
const daly: Recognizer = (bytes) => {
  const SIZE = 13;
  if (at(bytes, 0) !== 0xa5 || at(bytes, 3) !== 8) return undefined;
  if (bytes.length < SIZE) return bytes.length > 3 ? { protocol: 'daly', proof: 'shape', bits: 16 } : undefined;
  return (sumOf(bytes, 0, SIZE - 1) & 0xff) === at(bytes, SIZE - 1)
    ? { protocol: 'daly', proof: 'checksum', bits: 24 }
    : undefined;
};

/** JK batteries: 4E 57 and a length that counts what follows; 55 AA EB 90 or AA 55 90 EB over Bluetooth and RS-485. */
const jkBms: Recognizer = (bytes) => {
  const found = (proof: 'checksum' | 'shape', bits: number) => ({ protocol: 'jk-bms' as const, proof, bits });
  const head = (...marks: readonly number[]) => marks.every((mark, index) => at(bytes, index) === mark);
  if (head(0x55, 0xaa, 0xeb, 0x90) || head(0xaa, 0x55, 0x90, 0xeb)) return found('shape', 30);
  if (!head(0x4e, 0x57) || bytes.length < 4) return undefined;
  const end = 2 + word(bytes, 2);
  if (end > bytes.length) return found('shape', 16);
  const told = word(bytes, end - 2);
  return end > 8 && (sumOf(bytes, 0, end - 4) & 0xffff) === told ? found('checksum', 30) : found('shape', 16);
};

/** JBD and Xiaoxiang batteries: DD, A5 or 5A and a register or the other way round, a length, data, their sum negated, 77. */
const jbdBms: Recognizer = (bytes) => {
  if (at(bytes, 0) !== 0xdd || bytes.length < 7) return undefined;
  const isRequest = at(bytes, 1) === 0xa5 || at(bytes, 1) === 0x5a;
  if (!isRequest && at(bytes, 2) !== 0 && at(bytes, 2) !== 0x80) return undefined;
  const end = 4 + at(bytes, 3);
  if (end + 2 >= bytes.length) return { protocol: 'jbd-bms', proof: 'shape', bits: 16 };
  const told = word(bytes, end);
  return at(bytes, end + 2) === 0x77 && ((sumOf(bytes, 2, end) + told) & 0xffff) === 0
    ? { protocol: 'jbd-bms', proof: 'checksum', bits: 30 }
    : undefined;
};

/** Pylontech batteries: a tilde, hexadecimal digits of which the last four are the sum of the others negated, CR. */
const pylontech: Recognizer = (bytes) => {
  const [, said, told] = /^~([0-9A-F]{12,})([0-9A-F]{4})\r?\n?$/.exec(charactersOf(bytes)) ?? [];
  if (said === undefined || told === undefined) return undefined;
  let value = 0;
  for (let index = 0; index < said.length; index++) value += said.charCodeAt(index);
  const holds = ((value + Number.parseInt(told, 16)) & 0xffff) === 0;
  return { protocol: 'pylontech', proof: holds ? 'checksum' : 'shape', bits: holds ? 30 : 24 };
};

/** SML of electricity meters: 1B four times and 01 four times begin a message. */
const sml: Recognizer = (bytes) =>
  bytes.length >= 8 && [0x1b, 0x1b, 0x1b, 0x1b, 1, 1, 1, 1].every((byte, index) => at(bytes, index) === byte)
    ? { protocol: 'sml', proof: 'shape', bits: 30 }
    : undefined;

/** DL/T 645 of electricity meters: FE to wake, 68, six bytes of address, 68, control, length, data, their sum, 16. */
const dlt645: Recognizer = (bytes) => {
  let from = 0;
  while (at(bytes, from) === 0xfe) from++;
  if (at(bytes, from) !== 0x68 || at(bytes, from + 7) !== 0x68) return undefined;
  const end = from + 10 + at(bytes, from + 9);
  if (end + 1 >= bytes.length) return { protocol: 'dl-t-645', proof: 'shape', bits: 16 };
  return at(bytes, end + 1) === 0x16 && (sumOf(bytes, from, end) & 0xff) === at(bytes, end)
    ? { protocol: 'dl-t-645', proof: 'checksum', bits: 30 }
    : undefined;
};

/** M-Bus (EN 13757-2): 68 L L 68, L bytes, their sum, 16; or the short frame 10 C A sum 16. */
const mBus: Recognizer = (bytes) => {
  const found = (proof: 'checksum' | 'shape', bits: number) => ({ protocol: 'm-bus' as const, proof, bits });
  if (at(bytes, 0) === 0x10 && bytes.length === 5 && at(bytes, 4) === 0x16) {
    return (sumOf(bytes, 1, 3) & 0xff) === at(bytes, 3) ? found('checksum', 24) : undefined;
  }
  const length = at(bytes, 1);
  if (at(bytes, 0) !== 0x68 || at(bytes, 3) !== 0x68 || length !== at(bytes, 2) || length < 3) return undefined;
  const end = 4 + length;
  if (end + 1 >= bytes.length) return found('shape', 24);
  return at(bytes, end + 1) === 0x16 && (sumOf(bytes, 4, end) & 0xff) === at(bytes, end)
    ? found('checksum', 30)
    : undefined;
};

/** NMEA 0183: $ or !, characters, an asterisk and the exclusive or of those between them. */
const nmea: Recognizer = (bytes) => {
  const [, said, told] = /^[$!]([A-Z]{2,}[^*\r\n]*)\*([0-9A-Fa-f]{2})/.exec(charactersOf(bytes)) ?? [];
  if (said === undefined || told === undefined) return undefined;
  let value = 0;
  for (let index = 0; index < said.length; index++) value ^= said.charCodeAt(index);
  return { protocol: 'nmea', proof: value === Number.parseInt(told, 16) ? 'checksum' : 'shape', bits: 30 };
};

const MOST_CHARACTERS = 1024;
const charactersOf = (bytes: Uint8Array): string => String.fromCharCode(...bytes.subarray(0, MOST_CHARACTERS));

/** Words, as a console or a device with its own commands prints them. */
const text: Recognizer = (bytes) => {
  const characters = charactersOf(bytes);
  if (!/^[\t\n\r -~]*$/.test(characters) || !/[A-Za-z]{3}/.test(characters)) return undefined;
  // Hexadecimal text may be Modbus: other findings read it.
  if (/^:|^[\s0-9A-Fa-fxX,;:h-]*$/.test(characters)) return undefined;
  return { protocol: 'text', proof: 'characters', bits: Math.min(30, Math.floor(PRINTABLE_BITS * bytes.length)) };
};

/** The evidence, in bits, of a byte that is one of 97 characters out of 256. */
const PRINTABLE_BITS = 1.4;

const RECOGNIZERS: readonly Recognizer[] = [daly, jkBms, jbdBms, pylontech, sml, dlt645, mBus, nmea, text];

/** The protocol other than Modbus that has most evidence; `undefined` if none has any. */
export function otherProtocolOf(bytes: Uint8Array): Recognized | undefined {
  const found = RECOGNIZERS.flatMap((recognize) => recognize(bytes) ?? []);
  return found.length === 0 ? undefined : found.reduce((a, b) => (b.bits > a.bits ? b : a));
}
