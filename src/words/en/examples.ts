import { formatBytes } from '../../notation/index.ts';
import type { ExampleId, SourceId } from '../../workbench/index.ts';
import { all, bytesOf, code, word } from './common.ts';

/** What the sources of the examples are called, at the start of a sentence. */
const sources: Readonly<Record<SourceId, string>> = {
  weg: 'A guide for a WEG drive',
  's7-200': 'An article on an S7-200',
  'i-8xx7': 'The I-8xx7 manual',
  introduction: 'A Chinese introduction',
};

const names: Readonly<Record<ExampleId, string>> = {
  'weg-set-30-hz': 'Set 30 Hz',
  'weg-run': 'Run',
  'weg-stop': 'Stop',
  'weg-read-speed': 'Read the speed',
  'weg-speed': 'Reply: the speed',
  's7-200-read': 'Read 5 registers from 0',
  's7-200-write': 'Write 2 registers from 5',
  'i-8xx7-read-bits': 'Read 15 bits',
  'i-8xx7-bits': 'Reply: 15 bits',
  'i-8xx7-write-bit': 'Write a bit',
  'i-8xx7-bit-written': 'Reply: the bit is written',
  'i-8xx7-write-words': 'Write 2 words',
  'i-8xx7-words-written': 'Reply: 2 words are written',
  'i-8xx7-tcp-read-word': 'TCP: read a word',
  'i-8xx7-tcp-word': 'TCP reply: a word',
  'i-8xx7-tcp-read-bits': 'TCP: read 8 bits',
  'i-8xx7-tcp-bits': 'TCP reply: 8 bits',
  'introduction-read-40108': 'Read 40108–40110',
  'introduction-40108': 'Reply: 40108–40110',
  'introduction-read-401000': 'Read 401000–401003',
  'introduction-401000': 'Reply: 401000–401003',
};

/** What a frame is for, in the terms of its source. */
const about: Readonly<Record<ExampleId, string>> = {
  'weg-set-30-hz': 'Speed reference P0683 = 4096 of 8192, half of 60 Hz. Unit 6.',
  'weg-run': 'Control word P0682 = 1. Unit 6.',
  'weg-stop': 'Control word P0682 = 0. Unit 6.',
  'weg-read-speed': 'Actual speed P0681. Unit 6.',
  'weg-speed': 'The speed is 4096, which is 30 Hz.',
  's7-200-read': 'Function 03, unit 1.',
  's7-200-write': `Function ${code(0x10)}, unit 1. The article leaves the values open: here 1 and 2.`,
  'i-8xx7-read-bits': 'Function 01, from 0x1020. Unit 1.',
  'i-8xx7-bits': '0x1029 and 0x102C are on.',
  'i-8xx7-write-bit': 'Function 05, 0x0006 on. Unit 1.',
  'i-8xx7-bit-written': 'The request, repeated.',
  'i-8xx7-write-words': `Function ${code(0x10)}, 0x1234 and 0x5678 from 0x2100. Unit 1.`,
  'i-8xx7-words-written': 'Start and quantity, repeated.',
  'i-8xx7-tcp-read-word': 'At address 4. Unit 9, transaction 0x0102.',
  'i-8xx7-tcp-word': 'The word is 8.',
  'i-8xx7-tcp-read-bits': 'From address 2. Unit 7, transaction 0x0329.',
  'i-8xx7-tcp-bits': '0x49: addresses 2, 5 and 8 are on.',
  'introduction-read-40108': 'Function 03, from address 0x006B. Unit 17.',
  'introduction-40108': '555, 0 and 100.',
  'introduction-read-401000': 'Function 03, from address 999. Unit 33.',
  'introduction-401000': '12345, 54321, 6666 and 8888.',
};

const at = (places: readonly number[]) =>
  places.length === 1 ? `Byte ${places[0]} is wrong` : `Bytes ${all(places)} are wrong`;

/** What the examples say. */
export const examples = {
  intro: 'Frames from manuals and articles, each one click away. Back returns to the frame before.',
  sources,
  names,
  about,
  printed: 'The source prints',
  wrongByte: (bytes: Uint8Array) => `${formatBytes(bytes)} (wrong)`,
  /** Which printed bytes are wrong and why. The CRC is that of the bytes before it. */
  wrongCrc: (places: readonly number[], crc: number) =>
    `${at(places)}: the CRC of the bytes before is ${word(crc)}, sent low byte first as ${formatBytes(Uint8Array.of(crc & 0xff, crc >>> 8))}.`,
  wrongAddress: (places: readonly number[]) =>
    `${at(places)}: register 40108 is address 107, 0x006B. 0x000B is register 40012.`,
  noCheck: (missing: number) => `It leaves the checksum out, ${bytesOf(missing)}.`,
  noBytes: 'It prints no bytes for this frame, only what is in it.',
  /** Unfolds why what is printed is wrong. */
  why: 'Why',
  consequence: 'A device drops the frame as printed and does not answer.',
  /** What else is said of one example. */
  more: {
    'weg-set-30-hz':
      'Its worked steps go astray at the first shift: 0xFFF9, shifted and combined with 0xA001, is 0xDFFD, not 0xD7FC.',
  } as Partial<Record<ExampleId, string>>,
};
