import type { OpenPoint } from '../../workbench/index.ts';

/** What the specification leaves open. */
export const openPoints = {
  coilValue: {
    title: 'A coil value other than FF00 or 0000',
    text: 'The text calls it illegal and without effect on the coil; the state diagram answers it with exception 03. Some devices take every value but 0 as ON.',
  },
  padding: {
    title: 'Unused bits in the last byte of coils',
    text: 'They should be zero. The specification does not say what a device does otherwise, and the reply does not repeat the data.',
  },
  queryData: {
    title: 'How much data Return Query Data carries',
    text: 'Any number of 16-bit words, but no byte tells how many: on an RTU line only the silence ends the frame. Many devices take exactly one word.',
  },
  listenOnly: {
    title: 'Sub-functions that may get no reply',
    text: 'Restart Communications Option is answered, except in listen only mode. Force Listen Only Mode is never answered. Seen from the client, that silence is the same as a dead line.',
  },
  readFileLengths: {
    title: 'Lengths in the reply to Read File Record',
    text: 'The field table lets them begin at 07, its own example has 05, and one register needs 03. The request has room for 35 groups; what bounds the reply is that a PDU ends at 253 bytes.',
  },
  writeFileLength: {
    title: 'Longest data of Write File Record',
    text: 'The field table allows a data length from 09 to FB, the state diagram tests for 07 to F5.',
  },
  fifo: {
    title: 'Counting in Read FIFO Queue',
    text: 'Its byte count is two bytes wide, unlike any other. More than 31 values in the queue give exception 03. Its example calls address 04DE register 1246, without the one that every other example adds.',
  },
  objectCount: {
    title: 'Number of objects in a device identification',
    text: 'The text counts the objects of this reply; the example in two parts prints the total in both. An unknown object id starts a stream over at object 00, but is exception 02 when one object is asked for. An object of more than 244 bytes cannot be sent at all.',
  },
  canopen: {
    title: 'The body of CANopen General Reference',
    text: 'It is defined by CiA, not by the Modbus specification: here it is raw data.',
  },
  serverId: {
    title: 'What Report Server ID answers',
    text: "The byte count may cover everything behind it, as the Modicon guide has it, or the server id alone. Only the device's manual tells how long the id is, so the run indicator cannot be found without it.",
  },
  exceptionOrder: {
    title: 'Which exception comes first',
    text: 'Where both the address and the quantity are wrong, the transaction diagram answers 02, most state diagrams of the functions 03, and that of Read FIFO Queue 02 again.',
  },
  tcpUnit: {
    title: 'Unit identifier of a TCP server that is reached directly',
    text: 'FF “has to be used” and is “recommended”, and 00 is accepted also: three strengths for one rule. Sending FF and accepting both keeps to all of them.',
  },
  lrc: {
    title: 'What the LRC covers',
    text: 'The wording says the contents of the ASCII message. The examples show what is meant: the bytes that the characters stand for, without the colon, CR and LF.',
  },
  silence: {
    title: 'Silences with characters of 10 bits',
    text: 'A character on an RTU line has 11 bits, and 1.5 and 3.5 of them are the silences. Lines without parity often have only one stop bit, which makes 10: no formula is given, and many devices go on counting 11.',
  },
  oldLimits: {
    title: 'Smaller limits of old controllers',
    text: 'The Modicon guide lists maxima by controller that are lower than those of today, such as 800 coils and 100 registers in one write.',
  },
  mask: {
    title: 'The formula of Mask Write Register',
    text: 'Some copies of the text have lost the line above the last mask. The correct formula is (current AND and) OR (or AND NOT and).',
  },
  writeThenRead: {
    title: 'Order in Read/Write Multiple Registers',
    text: 'The write is done before the read, though the name has them the other way round: registers in both ranges come back as written.',
  },
  programFunctions: {
    title: 'Functions 13 and 14, exception 07',
    text: 'Program Controller, Poll Controller (decimal 13 and 14) and NEGATIVE ACKNOWLEDGE are in the Modicon guide only. The specification reserves the codes and does not know the exception.',
  },
  reservedSubFunctions: {
    title: 'Sub-functions 13 and 15 of Diagnostics',
    text: 'The Modicon guide defines them (hexadecimal, IOP overruns and Modbus Plus statistics); the specification reserves them.',
  },
  lowerCase: {
    title: 'Lower-case digits in an ASCII frame',
    text: 'Only 0–9 and A–F are listed. The specification does not say whether a–f are an error or must be read too.',
  },
} satisfies Readonly<Record<OpenPoint, { readonly title: string; readonly text: string }>>;
