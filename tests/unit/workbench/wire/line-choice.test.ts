import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { readSerialFormat } from '../../../../src/modbus/index.ts';
import {
  firstLine,
  lineChoice,
  readGapAt,
  readMilliseconds,
  readSpeed,
  storedLine,
  withLine,
} from '../../../../src/workbench/wire/line-choice.ts';

describe('what is typed of a line', () => {
  test('is a speed from 50 to 4,000,000', () => {
    expect(['50', '0x2580', '4000000'].map(readSpeed)).toEqual([50, 9600, 4_000_000]);
    for (const wrong of ['49', '4000001', '9600.5', 'fast', '', '-9600']) expect(readSpeed(wrong)).toBeUndefined();
  });

  test('is a time from 0 to 2000 ms', () => {
    expect(['0', '0.5', '5 ms', '2000ms'].map(readMilliseconds)).toEqual([0, 0.5, 5, 2000]);
    for (const wrong of ['-1', '2001', 'soon', '', '5 s']) expect(readMilliseconds(wrong)).toBeUndefined();
  });

  test('is the byte that a gap stands before, or blank', () => {
    expect([' ', '1', '0x7'].map((typed) => readGapAt(typed, 7))).toEqual([
      { gapAt: undefined },
      { gapAt: 1 },
      { gapAt: 7 },
    ]);
    for (const wrong of ['0', '8', '1.5', 'x']) expect(readGapAt(wrong, 7)).toBeUndefined();
  });
});

describe('the line that is kept', () => {
  test('is read back field by field, each as at first where it is not legal', () => {
    const stored = { device: 7, baud: -5, rtu: '9X3', ascii: 'purple', level: 'constructor', delay: 2001 };
    expect(storedLine(stored)).toEqual(firstLine);
    expect(storedLine({ ...stored, baud: 9600, level: 'ttl' })).toEqual({ ...firstLine, baud: 9600, level: 'ttl' });
    expect(storedLine({ baud: '9600' })).toEqual(firstLine);
  });

  test('comes out legal from any JSON, and comes back as it was', () => {
    const field = fc.oneof(fc.jsonValue(), fc.constantFrom('8E1', '7N2', 'ttl', 'rs232'), fc.integer());
    const like = fc.record(Object.fromEntries(Object.keys(firstLine).map((name) => [name, field])));
    fc.assert(
      fc.property(fc.oneof(like, fc.jsonValue()), (stored) => {
        const line = storedLine(JSON.parse(JSON.stringify(stored)));
        expect(readSpeed(String(line.baud))).toBe(line.baud);
        expect([readSerialFormat(line.rtu), readSerialFormat(line.ascii)]).not.toContain(undefined);
        expect(['rs485', 'rs232', 'ttl']).toContain(line.level);
        expect(line.delay >= 0 && line.delay <= 2000).toBe(true);
        expect(storedLine(JSON.parse(JSON.stringify(line)))).toEqual(line);
      }),
    );
  });
});

describe('how the line is set', () => {
  const weg = { id: 'weg', name: 'WEG drive', serial: { baud: 9600, ...readSerialFormat('8N1')! } };

  test('is as it was last, by the mode of the frame', () => {
    const memory = { ...firstLine, baud: 38_400, ascii: '7O1' };
    expect(lineChoice(memory, 'rtu', undefined)).toMatchObject({
      serial: { baud: 38_400, dataBits: 8, parity: 'even' },
    });
    expect(lineChoice(memory, 'ascii', undefined)).toMatchObject({ serial: { dataBits: 7, parity: 'odd' } });
  });

  test('is that of another device than then, until something is changed', () => {
    expect(lineChoice(firstLine, 'rtu', weg)).toMatchObject({ serial: weg.serial, device: 'WEG drive' });
    expect(lineChoice(firstLine, 'rtu', { id: 'x', name: 'no line' }).device).toBeUndefined();
    const changed = withLine(firstLine, 'rtu', weg, { serial: { ...weg.serial, parity: 'even' } });
    expect(changed).toEqual({ ...firstLine, device: 'weg', baud: 9600, rtu: '8E1' });
    expect(lineChoice(changed, 'rtu', weg)).toMatchObject({
      serial: { baud: 9600, parity: 'even' },
      device: undefined,
    });
  });
});
