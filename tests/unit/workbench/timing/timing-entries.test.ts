import { describe, expect, it } from 'vitest';
import {
  canCount,
  charactersEntry,
  devicesEntry,
  errorOf,
  knownOf,
  missingEntry,
  timeEntry,
  timingFormat,
  timingLine,
  timingMode,
} from '../../../../src/workbench/timing/timing-entries.ts';
import { firstTimingTexts, timingTexts } from '../../../../src/workbench/timing/timing-texts.ts';

const textsIn = (query: string) =>
  timingTexts((name) => new URLSearchParams(query).get(name) ?? undefined, firstTimingTexts);
const line = timingLine(textsIn('baud=9600&format=8N1'))!;

describe('what is typed', () => {
  it('is a time in microseconds, bits and characters those of the line', () => {
    expect(timeEntry('1.5 ms', line)).toEqual({ value: 1500 });
    expect(timeEntry('0x10', line)).toEqual({ value: 16_000 });
    expect(timeEntry('96 bits', line)).toEqual({ value: 10_000 });
    expect(timeEntry('12 chars', line)).toEqual({ value: 12_500 });
    expect(timeEntry('3600 s', line)).toEqual({ value: 3.6e9 });
    expect(timeEntry('3601 s', line)).toEqual({ error: { code: 'not-a-time', text: '3601 s' } });
    expect(timeEntry('soon', line)).toEqual({ error: { code: 'not-a-time', text: 'soon' } });
    expect(timeEntry(' ', line)).toEqual({ error: { code: 'field-missing' } });
  });

  it('is a line from 50 to 4,000,000 bits a second', () => {
    const silences = (query: string) => timingLine(textsIn(query))?.silences;
    expect(silences('baud=300&format=8N1')).toEqual({ t15: 50_000, t35: 116_666.66666666667 });
    expect(silences('baud=300&format=8N1&counted=11')).toEqual({ t15: 55_000, t35: 128_333.33333333333 });
    expect(silences('baud=0x3D0900')).toEqual({ t15: 750, t35: 1750 });
    for (const baud of ['49', '4000001', '9600.5', 'fast', '']) expect(silences(`baud=${baud}`)).toBeUndefined();
  });

  it('is a number of devices, and of those that do not answer', () => {
    const of = (devices: string) => devicesEntry({ ...firstTimingTexts, devices });
    expect([of('1'), of('247'), of('0x0A')]).toEqual([{ value: 1 }, { value: 247 }, { value: 10 }]);
    expect(of('0')).toEqual({ error: { code: 'number-out-of-range', got: 0, least: 1, most: 247 } });
    expect(of('248')).toEqual({ error: { code: 'number-out-of-range', got: 248, least: 1, most: 247 } });
    expect(of('')).toEqual({ error: { code: 'field-missing' } });
    const missing = (typed: string) => missingEntry({ ...firstTimingTexts, missing: typed }, 5);
    expect(missing('5')).toEqual({ value: 5 });
    expect(missing('6')).toEqual({ error: { code: 'number-out-of-range', got: 6, least: 0, most: 5 } });
  });

  it('is a number of characters, up to the longest frame, or that of the current frame', () => {
    expect(charactersEntry('', 'rtu', 1, 8)).toEqual({ value: 8 });
    expect(charactersEntry(' ', 'rtu', 1, undefined)).toEqual({ value: undefined });
    expect(charactersEntry('256', 'rtu', 1, 8)).toEqual({ value: 256 });
    expect(charactersEntry('257', 'rtu', 1, 8)).toEqual({
      error: { code: 'number-out-of-range', got: 257, least: 1, most: 256 },
    });
    expect(charactersEntry('513', 'ascii', 1, 8)).toEqual({ value: 513 });
    expect(errorOf(charactersEntry('514', 'ascii', 1, 8))).toBeDefined();
    expect(knownOf(charactersEntry('0', 'rtu', 0, 8))).toBe(0);
    expect(knownOf(charactersEntry('0', 'rtu', 1, 8))).toBeUndefined();
  });

  it('is a mode, or that of the current frame, and a format, or that of the specification', () => {
    const mode = (typed: string, ofFrame: string) => timingMode({ ...firstTimingTexts, mode: typed }, ofFrame);
    expect([mode('', 'ascii'), mode('', 'rtu'), mode('', 'tcp')]).toEqual(['ascii', 'rtu', 'rtu']);
    expect([mode('rtu', 'ascii'), mode('ascii', 'rtu'), mode('purple', 'ascii')]).toEqual(['rtu', 'ascii', 'rtu']);
    expect(timingFormat({ ...firstTimingTexts, format: '7O2' })).toEqual({ dataBits: 7, parity: 'odd', stopBits: 2 });
    expect(timingFormat({ ...firstTimingTexts, format: '9X3' })).toEqual({ dataBits: 8, parity: 'even', stopBits: 1 });
  });

  it('counts silences by a choice only in RTU, up to 19200, with characters of other than 11 bits', () => {
    const counts = (query: string, mode: 'rtu' | 'ascii' = 'rtu') => canCount(textsIn(query), mode);
    expect(counts('baud=9600&format=8N1')).toBe(true);
    expect(counts('baud=19200&format=8N1')).toBe(true);
    expect(counts('baud=19201&format=8N1')).toBe(false);
    expect(counts('baud=9600&format=8E1')).toBe(false);
    expect(counts('baud=9600&format=8N1', 'ascii')).toBe(false);
  });
});
