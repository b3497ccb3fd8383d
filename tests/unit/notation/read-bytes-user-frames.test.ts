import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { formatBytes, readBytes } from '../../../src/notation/index.ts';

interface UserFrame {
  readonly id: string;
  readonly pasted: string;
  readonly hex: string;
  readonly pastedIsProse?: boolean;
}

const userFrames = JSON.parse(
  readFileSync(new URL('../../vectors/user-frames.json', import.meta.url), 'utf8'),
) as readonly UserFrame[];
const pasted = userFrames.filter(({ pastedIsProse }) => pastedIsProse !== true);

test('there are as many as were collected', () => {
  expect(userFrames).toHaveLength(39);
  expect(pasted).toHaveLength(27);
});

test.each(pasted)('$id: $pasted', ({ pasted: text, hex }) => {
  const { bytes, problems } = readBytes(text);
  expect(formatBytes(bytes)).toBe(hex);
  expect(problems).toEqual([]);
});

// Descriptions rather than frames, which nevertheless say their bytes.
test.each(['user-21', 'user-22', 'user-36', 'user-54'])('%s', (id) => {
  const { pasted: text, hex } = userFrames.find((frame) => frame.id === id)!;
  expect(formatBytes(readBytes(text).bytes)).toBe(hex);
});
