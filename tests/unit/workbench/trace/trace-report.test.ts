import { expect, it } from 'vitest';
import { traceOf } from '../../../../src/trace/index.ts';
import { findings } from '../../../../src/words/en/findings.ts';
import { trace as words } from '../../../../src/words/en/trace.ts';
import { type ReportWords, traceReport } from '../../../../src/workbench/index.ts';
import { hex } from '../../captures/wire.ts';

const said: ReportWords = {
  ...words,
  title: 'Report',
  noFault: 'no faults',
  causes: 'Causes',
  cause: ({ code, explained }) => `${code} ${explained}`,
  faults: 'Faults',
  faultColumns: ['frame', 'time', 'unit', 'says', 'bytes'],
  finding: (of) => findings(of).title,
  filtered: (frames, filter) => `${frames} of ${filter}`,
  more: (count) => `${count} more`,
  statistics: 'By unit',
  unitColumns: ['unit', 'exchanges', 'replies', 'faults', 'median', '95 %', 'maximum'],
};
const place = { kind: 'text', from: 0, to: 0 } as const;
// AP 6.3's frames; one bit of byte 5 of the second reply is another.
const frames = [
  [0, '01 03 006B 0003 7417'],
  [4000, '01 03 06 022B 0000 0064 057A'],
  [1_000_000, '01 03 006B 0003 7417'],
  [1_008_000, '01 03 06 022A 0000 0064 057A'],
  ...[2, 3, 4].map((second) => [second * 1e6, '11 03 006B 0003 7687'] as const),
] as const;
const trace = traceOf(frames.map(([time, text]) => ({ bytes: hex(text), time, place })));

it('has a summary, causes, the faults with their frames, and statistics by unit', () => {
  expect(traceReport(trace, said)).toBe(`# Report

- 7 frames, 5 exchanges
- 1 wrong CRC
- 3 without a reply
- units 1, 17
- reply after 6.0 ms (median), 8.0 ms (maximum)

## Causes

- unit-silent 3

## Faults

| frame | time | unit | says | bytes |
| --- | --- | --- | --- | --- |
| 4 | 1.008000 | 1 | Read Holding Registers, wrong CRC. One bit of byte 5 is wrong | \`01 03 06 02 2A 00 00 00 64 05 7A\` |
| 5 | 2.000000 | 17 | Read 3 holding registers from 107 (40108), no reply | \`11 03 00 6B 00 03 76 87\` |
| 6 | 3.000000 | 17 | Read 3 holding registers from 107 (40108), no reply | \`11 03 00 6B 00 03 76 87\` |
| 7 | 4.000000 | 17 | Read 3 holding registers from 107 (40108), no reply | \`11 03 00 6B 00 03 76 87\` |

## By unit

| unit | exchanges | replies | faults | median | 95 % | maximum |
| --- | --- | --- | --- | --- | --- | --- |
| 1 | 2 | 2 | 1 | 6.0 ms | 8.0 ms | 8.0 ms |
| 17 | 3 | 0 | 3 |  |  |  |
`);
});

it('shows the faults of what is filtered, as they are and not as marks of Markdown', () => {
  const report = traceReport(
    trace,
    { ...said, sentence: () => '<b>*P_1* | x' },
    { source: 'my_log.txt', indexes: [3], filter: 'crc' },
  );
  expect(report).toContain('| 4 | 1.008000 | 1 | \\<b\\>\\*P\\_1\\* \\| x. One bit of byte 5 is wrong |');
  expect(report).toContain('\n- my\\_log.txt\n- 7 frames');
  expect(report).toContain('\n1 of `crc`\n');
  expect(report).not.toContain('| 5 |');
  expect(traceReport(trace, said, { indexes: [0], filter: 'a`b' })).toContain('\n1 of `` a`b ``\n\nno faults\n');
});

it('says of a trace without faults that it has none', () => {
  expect(traceReport(traceOf([]), said)).toBe('# Report\n\n- 0 frames, 0 exchanges\n- no faults\n');
});
