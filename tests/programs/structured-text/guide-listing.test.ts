import { expect, test } from 'vitest';
import { type GuideFault, guideFaults, guideListing } from '../../../src/codegen/examples/guide-listing.ts';
import { Machine } from './machine.ts';

const lines = guideListing.map(([line]) => line);
/** The number of a line, from 1, and what is wrong with it. */
const marked = guideListing.flatMap(([, fault], index) => (fault ? [[index + 1, fault] as const] : []));

/** What the compiler says first, the kind of fault it is, and what is changed so that it comes to the next kind. */
const mends: readonly (readonly [GuideFault, said: string, mend: (line: string) => string])[] = [
  ['comment', 'line 3: a comment begins with (*', (line) => line.replace(/\/\/(.*)/, '(* $1 *)')],
  [
    'shift-operator',
    'line 30: no operator >>',
    (line) => line.replace(/(\w+) >> 8/, 'WORD_TO_UINT(SHR(UINT_TO_WORD($1), 8))'),
  ],
  [
    'bits-of-number',
    'line 31: AND of UINT',
    (line) => line.replace(/\b(Register|Value) AND UINT#16#FF/, 'WORD_TO_UINT(UINT_TO_WORD($1) AND WORD#16#00FF)'),
  ],
  ['mixed-types', 'line 41: UINT XOR BYTE', (line) => line],
];

test('the listing of the guide is refused line by line, for what is said of the lines', () => {
  // Literals with their types, and DINT for counting: what other compilers do by themselves.
  let text = lines.map((line) =>
    line
      .replace(/(?<== )16#06/, 'BYTE#16#06')
      .replace(/(?<!BYTE#)16#/, 'UINT#16#')
      .replace(/ : INT;/, ' : DINT;'),
  );
  for (const [fault, said, mend] of mends) {
    expect(marked).toContainEqual([Number(/\d+/.exec(said)?.[0]), fault]);
    expect(() => new Machine(text.join('\n'))).toThrow(said);
    text = text.map(mend);
  }
});

test('each fault that is explained stands in the listing', () => {
  expect(new Set(marked.map(([, fault]) => fault))).toEqual(new Set(Object.keys(guideFaults)));
});
