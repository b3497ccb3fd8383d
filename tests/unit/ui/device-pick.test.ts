import { expect, test } from 'vitest';
import { typedIn, typeIn } from '../../../src/ui/address/convention.ts';
import { choose } from '../../../src/ui/device/chosen.ts';

test('a name is an address while its device is chosen, and the frame has a text that means the same to everybody', () => {
  choose('');
  expect(typeIn('address', 'P0683', 'holding-register')).toBe('P0683');
  choose('weg-drive');
  expect(typeIn('address', 'P0683', 'holding-register')).toBe('HR684');
  expect(typedIn('address', 'HR684', 'holding-register')).toBe('P0683');
  // Numbers stay what they are.
  expect(typeIn('address', '683', 'holding-register')).toBe('683');
  choose('s7-200');
  expect(typeIn('address', 'VW 804', 'holding-register')).toBe('HR3');
  expect(typeIn('address', 'P0683', 'holding-register')).toBe('P0683');
  // 40108 is a name of the Modicon's, and an address of its own first: a link has it so.
  choose('modicon-984');
  expect(typeIn('address', '40108', 'holding-register')).toBe('40108');
  choose('');
});
