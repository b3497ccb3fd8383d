import { expect, it } from 'vitest';
import { readCapture } from '../../../../src/captures/index.ts';
import { causesOf, traceOf } from '../../../../src/trace/index.ts';
import { demoLog } from '../../../../src/workbench/index.ts';

const read = () => readCapture(new TextEncoder().encode(demoLog()));

it('is the same each time, a line for each of its 200 frames', () => {
  expect(demoLog()).toBe(demoLog());
  expect(demoLog().split('\n').slice(0, 2)).toEqual([
    '10:31:12.000 Tx:000000-06 03 02 A9 00 02 14 24',
    expect.stringMatching(/^10:31:12\.0\d\d Rx:000001-06 03 04 /),
  ]);
  const { records, problems } = read();
  expect([records.length, problems]).toEqual([200, []]);
});

it('has the six faults that are planted in it, and no others', () => {
  const trace = traceOf(read().records);
  expect(trace.summary()).toMatchObject({
    frames: 200,
    exchanges: 101,
    units: [1, 6, 17],
    faults: {
      exception: 3,
      checksum: 1,
      'no-reply': 2,
      late: 0,
      doubtful: 0,
      mismatch: 0,
      broken: 0,
      stray: 0,
      timing: 0,
    },
  });
  const faults = trace
    .exchanges(0, 101)
    .flatMap(({ faults }, index) => faults.map(({ kind, exception }) => [index, kind, exception]));
  expect(faults).toEqual([
    [17, 'exception', 2],
    [31, 'no-reply', undefined],
    [46, 'checksum', undefined],
    [60, 'exception', 2],
    [74, 'exception', 6],
    [91, 'no-reply', undefined],
  ]);
  const damaged = Array.from({ length: 200 }, (_, index) => trace.record(index).findings[0]?.code);
  expect(damaged.filter((code) => code === 'bit-error')).toHaveLength(1);
  expect(causesOf(trace)).toEqual([]);
});
