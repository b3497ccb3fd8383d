import { describe, expect, it } from 'vitest';
import type { LogLine } from '../../../src/bus/index.ts';
import { traceOf } from '../../../src/trace/index.ts';
import { trace as words } from '../../../src/words/en/trace.ts';
import { exchangeRowOf, recordsOfLines, rowOf } from '../../../src/workbench/index.ts';
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

describe('a damaged reply', () => {
  const told = (request: string, reply: string) => {
    const damaged = traceOf([
      { bytes: hex(request), side: 'request' },
      { bytes: hex(reply), side: 'response' },
    ]);
    const row = rowOf(damaged, 1, undefined);
    return [words.functionOf(row), words.means(row)];
  };

  it('has the function of its own bytes, and says nothing of what another one was asked', () => {
    // Without their checksums, as some programs print frames.
    expect(told('06 06 02AA 0003', '06 03 02A9 0001')).toEqual(['03 Read Holding Registers', '']);
  });

  it('that is an exception without a checksum says which', () => {
    expect(told('01 03 0000 000A', '01 83 02')).toEqual([
      '03 Read Holding Registers',
      'exception 02, ILLEGAL DATA ADDRESS',
    ]);
  });
});

describe('what a row says of what the bus knows', () => {
  const ask = { direction: 'sent', kind: 'request', hex: '0103006B00037417' } as const;
  const answer = { direction: 'received', kind: 'reply', hex: '010306022B00000064057A' } as const;
  const noise = { direction: 'received', kind: 'noise', hex: 'FF00' } as const;
  const lines: readonly Omit<LogLine, 'time' | 'transport'>[] = [
    { ...ask, verdict: 'good' },
    { ...ask, direction: 'received', kind: 'echo' },
    noise,
    answer,
    { ...answer, kind: 'copy' },
    { ...answer, kind: 'other' },
    { ...ask, verdict: 'silent' },
    { ...answer, kind: 'late' },
    { ...ask, verdict: 'doubtful' },
    answer,
    { ...ask, verdict: 'absent' },
    { ...ask, verdict: 'ended' },
    { ...ask, verdict: 'refused' },
    { ...answer, kind: 'exception', hex: '018302C0F1' },
    { ...ask, verdict: 'silent' },
  ];
  const log = traceOf(recordsOfLines(lines.map((line, time) => ({ time, transport: 'rtu', ...line }))));
  const asks = 'Read 3 holding registers from 107 (40108)';
  const values = '40108 = 555, 40109 = 0, 40110 = 100';

  it.each([
    [0, asks],
    [1, `${asks}, echo of the request`],
    [2, '2 bytes, noise'],
    [3, values],
    [4, 'Read Holding Registers, the same frame again'],
    [5, 'Read Holding Registers, not asked for'],
    [6, asks],
    [7, `${values}, late reply`],
    [9, `${values}, may answer another request`],
    [10, `${asks}, no reply to a probe`],
    [11, `${asks}, stopped before its reply`],
    [13, 'exception 02, ILLEGAL DATA ADDRESS'],
    [14, `${asks}, no reply`],
  ])('line %i', (index, sentence) => {
    expect(words.sentence(rowOf(log, index, undefined))).toBe(sentence);
  });

  it('shows noise as bytes, of no unit and no function', () => {
    const row = rowOf(log, 2, undefined);
    expect([words.isFrame(row), words.functionOf(row), words.means(row)]).toEqual([false, 'not a frame', '2 bytes']);
    expect(words.functionOf(rowOf(log, 0, undefined))).toBe('03 Read Holding Registers');
  });
});
