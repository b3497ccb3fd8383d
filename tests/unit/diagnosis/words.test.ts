import { describe, expect, it } from 'vitest';
import { languages } from '../../../src/words/index.ts';
import { firstOf, type Known, userFrames } from './findings.ts';

const say = await languages.en.findings();
const rtu = { transport: 'rtu' } as const;

const said = (bytes: string, known: Known = rtu) => {
  const { title, why, todo } = say(firstOf(bytes, known));
  return `${title}. ${why} ${todo}`;
};

describe('the words of a finding have its numbers', () => {
  it.each([
    ['11 03 00 6B 00 03 87 76', ['swapped', '0x8776', '76 87', '87 76']],
    ['05 03 11 97 00 01 4C 5C', ['“05 03 11 97 00 01”', '4C 5C', '31 5E']],
    ['06 06 02 AB 10 00 E6 A1', ['F5 E5', 'E6 A1']],
    ['01 04 00 00 00 01 FA', ['LRC', 'FA', '31 CA']],
    ['11 03 00 7B 00 03 76 87', ['byte 4', '6B', '7B', 'bit 4']],
    ['01 03 3E 00 71 02 7B', ['60 bytes', '67', '7 are here']],
    ['01 83 02 C0 F1', ['ILLEGAL DATA ADDRESS', 'function 03', 'counts from 1']],
    ['11 05 00 AC 00 01 CE BB', ['0x0001', 'FF00']],
    ['01 03 00 00 00 7E C5 EA', ['126', '1 to 125', 'AP 6.3']],
  ])('%s', (bytes, parts) => {
    const words = said(bytes);
    for (const part of parts) expect(words).toContain(part);
  });

  it('units in both notations', () => {
    const words = said('17 06 40 03 00 17 2E F2', { ...rtu, request: '01 06 40 03 00 17 2C 04' });
    expect(words).toContain('unit 23 (0x17)');
    expect(words).toContain('unit 1 (0x01)');
  });
});

it.each(userFrames.map((frame) => [frame.id, frame] as const))('%s is said in whole sentences', (_, frame) => {
  const { title, why, todo } = say(firstOf(frame.hex, { ...(frame.answering && { request: frame.answering }) }));
  for (const text of [title, why, todo]) expect(text).not.toMatch(/undefined|NaN|null|\[object| {2}|\.\.|^$/);
  expect(title).not.toMatch(/\.$/);
  for (const text of [why, todo]) expect(text).toMatch(/^[A-Z“0-9].*\.$/s);
});
