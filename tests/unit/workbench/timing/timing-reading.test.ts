import { expect, test } from 'vitest';
import { readLink } from '../../../../src/workbench/frame/link.ts';
import { readTiming } from '../../../../src/workbench/timing/timing-reading.ts';
import { firstTimingTexts } from '../../../../src/workbench/timing/timing-texts.ts';

const draftOf = (link: string) => readLink(link)!.draft;
const READ = draftOf('rtu/request?unitId=17&functionCode=3&startAddress=107&quantity=3');
const BROADCAST = draftOf('rtu/request?unitId=0&functionCode=6&address=1&value=3');
const line = { ...firstTimingTexts, baud: '9600', format: '8N1' };

test('a round asks each device once; a silent one costs the time-out', () => {
  const { round } = readTiming({ ...line, devices: '10', missing: '2', timeout: '100 ms', gap: '' }, READ);
  // 8 × 10 + 35 + 11 × 10 + 35 bits, at 9600 a second 27083.3 µs, for each of eight; a request of 80 bits and 100 ms for two.
  expect(round?.time).toBeCloseTo(8 * (260e6 / 9600) + 2 * (80e6 / 9600 + 100_000), 6);
  expect(round?.lost).toBeCloseTo(2 * (80e6 / 9600 + 100_000), 6);
  expect(round).toMatchObject({ devices: 10, missing: 2, toAll: false, tooLate: false });
});

test('a device that answers after the time-out is too late, one that answers at it is not', () => {
  expect(readTiming({ ...line, delay: '101 ms', timeout: '100 ms' }, READ).round?.tooLate).toBe(true);
  expect(readTiming({ ...line, delay: '100 ms', timeout: '100 ms' }, READ).round?.tooLate).toBe(false);
});

test('a broadcast goes to all at once: the turnaround counts, and nobody is too late', () => {
  const { answered, exchange, round } = readTiming({ ...line, turnaround: '200 ms', timeout: '100 ms' }, BROADCAST);
  expect(answered).toBe(false);
  expect(exchange).toMatchObject({ request: 8, reply: 0, delay: 200_000 });
  expect(round).toMatchObject({ toAll: true, tooLate: false });
  // 80 bits and the turnaround.
  expect(round?.time).toBeCloseTo(80e6 / 9600 + 200_000, 6);
});

test('a gap is read by the rules of the mode', () => {
  // Counted by 10 bits, t1.5 is 1.5625 ms here; by 11 bits 1.719 ms.
  expect(readTiming({ ...line, gap: '1.6 ms' }, READ).gap).toEqual({
    effect: 'discarded',
    other: { bits: 11, effect: 'whole' },
  });
  expect(readTiming({ ...line, mode: 'ascii', gap: '1.6 ms' }, READ).gap).toEqual({
    effect: 'whole',
    other: undefined,
  });
  expect(readTiming({ ...line, gap: 'long' }, READ).gap).toBeUndefined();
  expect(readTiming({ ...line, baud: 'fast', gap: '1.6 ms' }, READ).gap).toBeUndefined();
});

test('more devices than there are cannot be silent', () => {
  const { entries, round } = readTiming({ ...line, devices: '3', missing: '4' }, READ);
  expect(entries.missing).toEqual({ error: { code: 'number-out-of-range', got: 4, least: 0, most: 3 } });
  expect(round).toBeUndefined();
});
