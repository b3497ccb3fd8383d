import { plural } from './en-numbers.ts';
import { pasting } from './en-pasting.ts';

/** What the Checksum view says. */
export const checksum = {
  title: 'Framewright: checksums',
  input: 'Bytes',
  readAs: pasting.readAs,
  problems: pasting.problems,
  kind: 'Input is',
  kinds: { bytes: 'Bytes', text: 'Text' },
  kindHints: { bytes: 'Hexadecimal, decimal, a dump, a log, code', text: 'The characters themselves, as UTF-8' },
  hints: {
    bytes: 'Anything that says bytes: hexadecimal, decimal, a dump, a line of a log.',
    text: 'The bytes of the characters themselves, as UTF-8.',
  },
  frameAtHand: 'The frame at hand:',
  body: 'without its checksum',
  whole: 'as it is sent',
  count: (count: number) => plural(count, 'byte'),
  result: 'Checksum',
  number: 'number',
  wire: 'on the wire',
  steps: 'Step by step',
  stepsHint: 'How each bit of these bytes changes the register.',
};

export type ChecksumWords = typeof checksum;
