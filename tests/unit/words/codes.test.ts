import { expect, test } from 'vitest';
import { code, codeWithin } from '../../../src/words/en/numbers.ts';

// A code without its base misleads: 16 is Write Multiple Registers, 0x16 is Mask Write Register (AP 5.1).
test('a code is written in both bases where they differ', () => {
  expect([3, 9, 10, 16, 22, 43].map(code)).toEqual(['03', '09', '10 (0x0A)', '16 (0x10)', '22 (0x16)', '43 (0x2B)']);
  expect(codeWithin(43, 14)).toBe('43/14 (0x2B/0x0E)');
  expect(codeWithin(8, 1)).toBe('08/01');
});
