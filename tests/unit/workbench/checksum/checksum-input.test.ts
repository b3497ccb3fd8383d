import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { readInput } from '../../../../src/workbench/checksum/checksum-input.ts';
import { anyCharacter } from '../../any-character.ts';
import { hex } from '../../modbus/frames.ts';

describe('the input of a checksum', () => {
  it('is bytes in any notation', () => {
    const { bytes, notation, problems } = readInput('21 03 03 E7 00 04', 'bytes');
    expect(bytes).toEqual(hex('21 03 03 E7 00 04'));
    expect(notation).toBeDefined();
    expect(problems).toEqual([]);
  });

  it('has at most 20 problems to show', () => {
    expect(readInput('xyz '.repeat(50), 'bytes').problems.length).toBeLessThanOrEqual(20);
    expect(readInput('zz', 'bytes').problems.length).toBeGreaterThan(0);
  });

  it.each([
    ['123456789', '31 32 33 34 35 36 37 38 39'],
    ['µ', 'C2 B5'],
    ['€', 'E2 82 AC'],
    ['😀', 'F0 9F 98 80'],
    ['\ud83d', 'EF BF BD'],
  ])('is the characters of a text as UTF-8: %j', (text, bytes) => {
    expect(readInput(text, 'text')).toEqual({ bytes: hex(bytes), problems: [] });
  });

  it('is the same UTF-8 as everywhere', () => {
    fc.assert(
      fc.property(fc.string({ unit: anyCharacter }), (text) => {
        expect(readInput(text, 'text').bytes).toEqual(new TextEncoder().encode(text));
      }),
    );
  });
});
