import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { serialFormats } from '../../../../src/modbus/index.ts';
import {
  firstLine,
  lineText,
  readLineText,
  readSpeed,
  storedLine,
} from '../../../../src/workbench/line/line-setting.ts';

test('a speed is a whole number from 50 to 4,000,000', () => {
  expect(['50', '0x2580', '4000000'].map(readSpeed)).toEqual([50, 9600, 4_000_000]);
  for (const wrong of ['49', '4000001', '9600.5', 'fast', '', '-9600']) expect(readSpeed(wrong)).toBeUndefined();
});

describe('the line in a link', () => {
  test('is its speed and the name of its format', () => {
    expect(lineText({ baud: 9600, dataBits: 8, parity: 'none', stopBits: 1 })).toBe('9600-8N1');
    expect(readLineText('19200-8E1')).toEqual({ baud: 19_200, dataBits: 8, parity: 'even', stopBits: 1 });
    expect(readLineText(' 115200 7o2 ')).toEqual({ baud: 115_200, dataBits: 7, parity: 'odd', stopBits: 2 });
    for (const wrong of ['', '9600', '8N1', '49-8N1', '4000001-8N1', '9600-8X1', '-9600-8N1']) {
      expect(readLineText(wrong), wrong).toBeUndefined();
    }
  });

  test('is read back as it was written', () => {
    const line = fc.tuple(fc.integer({ min: 50, max: 4_000_000 }), fc.constantFrom(...serialFormats));
    fc.assert(
      fc.property(line, ([baud, format]) => {
        expect(readLineText(lineText({ baud, ...format }))).toEqual({ baud, ...format });
      }),
    );
  });
});

describe('the line that is kept', () => {
  test('is read back field by field, each as at first where it is not legal', () => {
    const stored = { device: 7, baud: -5, dataBits: 9, parity: 'purple', stopBits: 7 };
    expect(storedLine(stored)).toEqual(firstLine);
    expect(storedLine({ ...stored, baud: 9600, parity: 'odd' })).toEqual({ ...firstLine, baud: 9600, parity: 'odd' });
    expect(storedLine({ baud: '9600' })).toEqual(firstLine);
  });

  test('comes out legal from any JSON, and comes back as it was', () => {
    const field = fc.oneof(fc.jsonValue(), fc.constantFrom('none', 'odd', 7, 8, 2), fc.integer());
    const like = fc.record(Object.fromEntries(Object.keys(firstLine).map((name) => [name, field])));
    fc.assert(
      fc.property(fc.oneof(like, fc.jsonValue()), (stored) => {
        const line = storedLine(JSON.parse(JSON.stringify(stored)));
        expect(readLineText(lineText(line))).toBeDefined();
        expect(storedLine(JSON.parse(JSON.stringify(line)))).toEqual(line);
      }),
    );
  });
});
