import { describe, expect, it } from 'vitest';
import { traceOf } from '../../../src/trace/index.ts';
import { trace as words } from '../../../src/words/en/trace.ts';
import { exchangeRowOf, rowOf } from '../../../src/workbench/index.ts';
import { hex } from '../captures/wire.ts';

// AP 6.3, 6.6, 6.1 and 6.7, AP 7's exception 02, and a reply of AP 6.3 in which one bit of byte 5 is another.
const trace = traceOf(
  [
    '01 03 006B 0003 7417',
    '01 03 06 022B 0000 0064 057A',
    '01 06 0001 0003 980B',
    '01 06 0001 0003 980B',
    '01 01 0013 0013 8C02',
    '01 81 02 C191',
    '11 03 006B 0003 7687',
    '01 03 006B 0003 7417',
    '01 03 06 022B 0001 0064 057A',
    '01 07 41E2',
    '11 03 006B 0003 7687',
  ].map((text) => ({ bytes: hex(text), place: { kind: 'text', from: 0, to: 0 } as const })),
);

describe('what a row says', () => {
  it.each([
    [0, 'Read 3 holding registers from 107 (40108)'],
    [1, '40108 = 555, 40109 = 0, 40110 = 100'],
    [2, 'Write 40002 = 3'],
    [3, 'Write Single Register'],
    [4, 'Read 19 coils from 19 (00020)'],
    [5, 'exception 02, ILLEGAL DATA ADDRESS'],
    [6, 'Read 3 holding registers from 107 (40108), no reply'],
    [8, 'Read Holding Registers, wrong CRC'],
    [9, 'Read Exception Status, no reply'],
  ])('frame %i', (index, sentence) => {
    expect(words.sentence(rowOf(trace, index, undefined))).toBe(sentence);
  });

  it.each([
    [0, 'Read 3 holding registers from 107 (40108), 40108 = 555, 40109 = 0, 40110 = 100'],
    [2, 'Read 19 coils from 19 (00020), exception 02, ILLEGAL DATA ADDRESS'],
    [3, 'Read 3 holding registers from 107 (40108), no reply'],
    [4, 'Read 3 holding registers from 107 (40108), Read Holding Registers, wrong CRC'],
  ])('exchange %i', (index, sentence) => {
    expect(words.sentence(exchangeRowOf(trace, index, undefined))).toBe(sentence);
  });
});
