import fc from 'fast-check';
import { expect, test } from 'vitest';
import { bitEffects, maskedValue, masksFor } from '../../../../src/modbus/index.ts';

test('the example of AP 6.16: 12 with AND F2 and OR 25 becomes 17', () => {
  expect(maskedValue(0x12, { andMask: 0xf2, orMask: 0x25 })).toBe(0x17);
});

test('masks that set and clear bits', () => {
  // Bit 0 set, bit 3 cleared.
  expect(masksFor(0x0001, 0x0008)).toEqual({ andMask: 0xfff6, orMask: 0x0001 });
  expect(masksFor(0, 0)).toEqual({ andMask: 0xffff, orMask: 0 });
  expect(masksFor(0xffff, 0)).toEqual({ andMask: 0, orMask: 0xffff });
  // Where the AND mask is 1, the OR mask does nothing.
  const effects = bitEffects({ andMask: 0b0011, orMask: 0b0101 });
  expect(effects.slice(0, 4)).toEqual(['keep', 'keep', 'set', 'clear']);
});

test('a register becomes what was asked for', () => {
  const bits = fc.nat(0xffff);
  fc.assert(
    fc.property(bits, bits, bits, (current, set, cleared) => {
      const clear = cleared & ~set;
      expect(maskedValue(current, masksFor(set, clear))).toBe((current | set) & ~clear);
    }),
  );
});
