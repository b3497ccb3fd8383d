import type { PrintedVerdict } from '../../modbus/index.ts';
import { plural } from './common.ts';

const verdicts: Readonly<Record<PrintedVerdict['kind'], string>> = {
  right: 'right',
  follows: 'by the rule, of a wrong register',
  wrong: 'wrong',
};

/** What the steps of a checksum say. */
export const checksumSteps = {
  form: (bits: number, initial: string) => `A register of ${plural(bits, 'bit')} begins as ${initial}.`,
  roomForByte: (width: number) => `The CRC has only ${plural(width, 'bit')}; a byte needs eight.`,
  moves: (reflected: boolean, poly: string) =>
    reflected
      ? `Each byte is xored into its low end. A shift moves it to the right; if the bit that leaves is 1, ${poly} is xored in: the polynomial, reversed.`
      : `Each byte is xored into its high end. A shift moves it to the left; if the bit that leaves is 1, ${poly} is xored in: the polynomial.`,
  nothing: 'There are no bytes to step through.',
  firstOnly: (shown: number, all: number) =>
    `Only the first ${shown} of ${all} bytes are shown; the CRC is that of these bytes.`,
  list: 'Steps',
  columns: { step: 'Step', before: 'Register before', out: 'Out', xor: 'Xor', after: 'Register after' },
  byte: (at: number) => `Byte ${at}`,
  shift: (number: number) => `shift ${number}`,
  mix: (byte: string, mixed: string) => `xor ${byte} = ${mixed}`,
  xor: (poly: string) => `xor ${poly}`,
  noXor: 'no xor',
  byteSaid: (at: number, byte: string, before: string, mixed: string, after: string) =>
    `Byte ${at}: ${before} xor ${byte} is ${mixed}. Eight shifts make it ${after}.`,
  shiftSaid: (number: number, at: number, moved: string, poly: string | undefined, after: string) =>
    poly === undefined
      ? `Shift ${number} of byte ${at}: a 0 leaves. The register is ${after}.`
      : `Shift ${number} of byte ${at}: a 1 leaves. ${moved} xor ${poly} is ${after}.`,
  first: 'First',
  back: 'Back',
  play: 'Play',
  stop: 'Stop',
  forward: 'Forward',
  last: 'Last',
  atFirst: 'This is the first row.',
  atLast: 'This is the last row.',
  speed: 'Speed',
  perSecond: (rows: number) => `${plural(rows, 'row')} a second`,
  goTo: 'Byte, or byte.shift',
  go: 'Go',
  goToHint: '5, 0x0A, 5.3',
  noSuchByte: (last: number) => `There are bytes 0 to ${last}, in decimal or as 0x0A, and shifts 1 to 8: 5.3`,
  foldAll: 'Fold all',
  unfoldAll: 'Unfold all',
  copySteps: 'Copy the steps',
  copied: 'Copied',
  copyFailed: 'The browser refused.',
  keys: 'Keys',
  keyNames: [
    { keys: ['↓', '↑'], does: 'one row forward, back' },
    { keys: ['→', '←'], does: 'unfold, fold the byte' },
    { keys: ['Shift →', 'Shift ←'], does: 'unfold, fold all' },
    { keys: ['Page Down', 'Page Up'], does: 'next, previous byte' },
    { keys: ['Home', 'End'], does: 'first, last row' },
    { keys: ['Space'], does: 'play, stop' },
    { keys: ['+', '−'], does: 'faster, slower' },
    { keys: ['G'], does: 'go to a byte' },
  ],
  result: (register: string) => `After the last byte the register is ${register}.`,
  turned: (value: string) => `Read the other way round it is ${value}.`,
  finalXor: (xorout: string) => `Xor ${xorout}, the final one, gives`,
  noFinalXor: 'That is',
  value: 'the CRC:',
  sent: 'sent as',

  table: {
    title: 'With the table',
    one: (at: number) => `Byte ${at} in one step`,
    index: 'Index',
    entry: 'Entry of the table',
    moved: 'Register, moved 8 bits',
    after: 'Register after',
    indexIs: (mixed: string, reflected: boolean) => `the ${reflected ? 'low' : 'high'} byte of ${mixed}`,
    xorOf: (moved: string, entry: string) => `${moved} xor ${entry}`,
    why: 'Why this is the same',
    whyText: (reflected: boolean) =>
      `Which shifts xor is decided by the bits that leave, and in eight shifts only the ${
        reflected ? 'low' : 'high'
      } byte leaves, with what the shifts make of it. The other bits only move. So the register can be taken apart: in every row the two on the right, xored, are the one on the left.`,
    shifts: 'Shifts',
    whole: 'Register',
    alone: (reflected: boolean) => `Its ${reflected ? 'low' : 'high'} byte alone`,
    rest: 'The rest alone',
    becomes: (index: string, entry: string) =>
      `The eight shifts of ${index} alone give ${entry}. There are 256 such bytes; their results, calculated once, are the table.`,
  },
  two: {
    title: 'With two tables of bytes',
    intro:
      'For processors of 8 bits the table is split in two. The first half of the register is the byte that meets the data, which is also the one that is sent first.',
    names:
      'SL 6.2.2 calls the tables auchCRCHi and auchCRCLo, the I-8xx7 manual TABLE2 and TABLE1. Mind the names: “Hi” there is the byte sent first, the low byte of the register.',
    index: 'Index',
    first: 'First half',
    second: 'Second half',
    indexIs: (byte: string, first: string) => `${byte} xor first half ${first}`,
    firstIs: (second: string, entry: string) => `second half ${second} xor auchCRCHi ${entry}`,
    secondIs: 'auchCRCLo',
  },
  entries: {
    title: 'The table',
    caption: 'What eight shifts make of each of the 256 bytes. The entry for the current byte is marked.',
    kinds: { whole: 'One table', two: 'Two tables' },
    kind: 'Form',
    language: 'Language',
    languages: { c: 'C', st: 'Structured Text' },
    copy: 'Copy',
    program: 'For a program',
  },
  receiver: {
    title: 'At the receiver',
    intro: (sent: string) =>
      `A receiver does not have to remove the CRC. It goes on over ${sent} after the bytes, and what is left is always the same.`,
    left: (residue: string) => `The residue, which is what is left: ${residue}.`,
    whyZero:
      'Each byte of the CRC meets the same byte in the register, and the two cancel out: every index is 0, no bit that leaves is 1.',
    whyConstant: 'Because of the final xor it is not 0, but it does not depend on the bytes.',
    whyTitle: 'Why the low byte goes first',
    why: {
      low: 'The register moves to the right, and a serial line sends the lowest bit of each byte first. With the low byte first, the bits of the CRC come in the order in which they leave the register, so that the check at the end comes out. Data in Modbus has its high byte first; only the CRC does not (SL 2.5.1.2).',
      high: 'The register moves to the left: its highest bit leaves first. So this CRC is sent with its high byte first, unlike that of Modbus.',
    },
    whyTitleHigh: 'Why the high byte goes first',
    swapped: (sent: string, left: string) => `The other way round, ${sent}, would leave ${left}.`,
    ends: (size: number) =>
      `The bytes above already end in their own CRC, the last ${plural(size, 'byte')}: the register after them is this one too.`,
    notBytes: 'This CRC is not sent as whole bytes, so that a receiver compares it instead.',
  },
  lrc: {
    title: 'The LRC, step by step',
    hint: 'Of ASCII frames: the bytes are added.',
    columns: { byte: 'Byte', value: 'Value', before: 'Sum before', after: 'Sum after' },
    sum: (sum: string) => `Carries out of 8 bits are dropped. The sum is ${sum}.`,
    twos: (inverted: string, value: string) =>
      `All bits turned over it is ${inverted}; plus 1, ${value}. Sum and LRC add up to 0, which is what the receiver checks (SL 2.5.2.2).`,
  },
  example: {
    title: 'A printed example that is wrong',
    hint: 'From a guide for a WEG drive: wrong from its first line.',
    intro:
      'The guide gives the right rule and the right program, but its worked example was not made with them. Whoever checks a program against these lines looks for a fault that is not there.',
    start: (mixed: string) => `It begins well: 0xFFFF xor 0x06 is ${mixed}.`,
    columns: { line: 'Line', printed: 'Printed', byRule: 'The rule gives', right: 'Right', verdict: 'The line is' },
    line: (bit: number) => `Bit ${bit}`,
    out: (bit: number, register: string) => `${bit} leaves, ${register}`,
    verdicts,
    ruleHint: '“The rule gives” takes the register printed in the line before.',
    registers: { what: 'What', printed: 'Printed', right: 'Right' },
    afterByte: (at: number) => `Register after byte ${at}`,
    final: 'CRC',
    sent: 'Sent as',
    open: 'Step through this frame',
  },
};
