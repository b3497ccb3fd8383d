import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { readClaim } from '../../../../src/workbench/checksum/claim.ts';
import { hex } from '../../modbus/frames.ts';

describe('a claimed value', () => {
  it.each([
    ['0x1AF3', ['1AF3']],
    ['1AF3', ['1AF3']],
    ['F3 1A', ['F31A']],
    ['6899', ['6899', '1AF3']],
    ['18', ['18', '12']],
    ['1AF3h', ['1AF3']],
    ['0x83E7A032', ['83E7A032']],
    ['12 34 56', []],
    ['x', []],
    ['', []],
  ])('%s', (text, claims) => {
    expect(readClaim(text)).toEqual(claims.map(hex));
  });

  it('may be any text', () => {
    fc.assert(
      fc.property(fc.string(), (text) => {
        for (const { length } of readClaim(text)) expect([1, 2, 4]).toContain(length);
      }),
    );
  });
});
