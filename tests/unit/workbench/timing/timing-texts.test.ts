import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { readSerialFormat } from '../../../../src/modbus/index.ts';
import { devicesEntry, knownOf, timeEntry, timingLine } from '../../../../src/workbench/timing/timing-entries.ts';
import {
  firstTimingTexts,
  keptTexts,
  storedTexts,
  timingTexts,
} from '../../../../src/workbench/timing/timing-texts.ts';

describe('the texts of an address', () => {
  it('are as kept where it leaves something out', () => {
    const kept = { ...firstTimingTexts, baud: '9600' };
    const texts = timingTexts((name) => (name === 'gap' ? '5 chars' : undefined), kept);
    expect(texts).toEqual({ ...kept, gap: '5 chars' });
  });
});

describe('the texts that are kept', () => {
  it('are those of the devices', () => {
    const texts = { ...firstTimingTexts, baud: '9600', mode: 'ascii', request: '8', reply: '11', gap: '5 chars' };
    expect(keptTexts(texts)).toEqual({ ...firstTimingTexts, gap: '5 chars' });
  });

  it('are read back field by field, each as at first where it is not legal', () => {
    const stored = { baud: '-5', format: '8X1', counted: 'all', delay: 'soon', devices: '248', gap: '5 chars' };
    expect(storedTexts(stored)).toEqual({ ...firstTimingTexts, gap: '5 chars' });
    expect(storedTexts({ baud: 9600 })).toEqual(firstTimingTexts);
    expect(storedTexts({ baud: '0x2580', format: '8N1', counted: '11', missing: '3', timeout: '0.5 s' })).toEqual({
      ...firstTimingTexts,
      counted: '11',
      missing: '3',
      timeout: '0.5 s',
    });
    expect(storedTexts({ mode: 'ascii', request: '8', reply: '11' })).toEqual(firstTimingTexts);
    for (const nothing of [null, [], 'x', 7]) expect(storedTexts(nothing)).toEqual(firstTimingTexts);
  });

  it('come out legal from any JSON, and come back as they were', () => {
    const word = fc.constantFrom('-5', '9600', '8E1', '7N2', '11', '10 ms', '5 chars', 'soon', '', '247', '1e999');
    const texts = fc.record(
      Object.fromEntries(Object.keys(firstTimingTexts).map((name) => [name, fc.oneof(word, fc.jsonValue())])),
      { requiredKeys: [] },
    );
    fc.assert(
      fc.property(fc.oneof(texts, fc.jsonValue()), (stored) => {
        const read = storedTexts(JSON.parse(JSON.stringify(stored)));
        expect(timingLine(read)).toBeDefined();
        expect(readSerialFormat(read.format)).toBeDefined();
        expect(knownOf(devicesEntry(read))).toBeDefined();
        for (const time of [read.delay, read.turnaround, read.timeout, read.gap]) {
          expect(knownOf(timeEntry(time, undefined)), time).toBeDefined();
        }
        expect(storedTexts(JSON.parse(JSON.stringify(read)))).toEqual(read);
      }),
    );
  });
});
