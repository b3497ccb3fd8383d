import { describe, expect, test } from 'vitest';
import { compareFrames } from '../../../src/diagnosis/index.ts';
import type { DecodeContext, Direction } from '../../../src/modbus/index.ts';
import frames from '../../vectors/frames.json' with { type: 'json' };
import { bytes, said } from './compare.ts';

const LONGEST = 60;
const published = frames
  .filter(({ transport }) => transport === 'rtu')
  .map(({ hex, direction }) => ({ hex, frame: bytes(hex), direction: direction as Direction }))
  .filter(({ frame }) => frame.length <= LONGEST);

/** Every published RTU frame, damaged in one way, is said to be damaged in that way and no other. */
describe('published RTU frames', () => {
  const each = (check: (frame: Uint8Array, context: DecodeContext, hex: string) => void) => {
    expect(published.length).toBeGreaterThan(200);
    for (const { frame, direction, hex } of published) check(frame, { transport: 'rtu', direction }, hex);
  };
  const codes = (mine: Uint8Array, theirs: Uint8Array, context: DecodeContext) =>
    compareFrames(mine, theirs, context).differences.map(({ cause }) => cause.code);

  test('with the CRC bytes swapped', () => {
    each((frame, context, hex) => {
      const [low = 0, high = 0] = frame.subarray(-2);
      if (low === high) return;
      expect(codes(frame, Uint8Array.of(...frame.subarray(0, -2), high, low), context), hex).toEqual([
        'checksum-swapped',
      ]);
    });
  });

  test('cut off, after any byte', () => {
    each((frame, context, hex) => {
      for (let length = 3; length < frame.length; length++) {
        const missing = frame.length - length;
        const cause = missing === 2 ? { code: 'checksum-missing' } : { code: 'truncated', missing };
        const { differences } = said(compareFrames(frame, frame.subarray(0, length), context));
        expect(
          differences.map(([, why]) => why),
          `${length} bytes of ${hex}`,
        ).toEqual([cause]);
      }
    });
  });

  test('with a byte of the CRC wrong', () => {
    each((frame, context, hex) => {
      const wrong = Uint8Array.of(...frame.subarray(0, -1), (frame.at(-1) as number) ^ 0x55);
      expect(codes(frame, wrong, context), hex).toEqual(['checksum-alone-wrong']);
    });
  });

  test('from another unit, with the CRC of the first', () => {
    each((frame, context, hex) => {
      const wrong = Uint8Array.of((frame[0] as number) ^ 0x40, ...frame.subarray(1));
      const { causes, differences } = said(compareFrames(frame, wrong, context));
      expect(causes, hex).toEqual([{ code: 'changed-after-checksum' }]);
      expect(differences, hex).toMatchObject([['unitId', { code: 'unit-differs' }]]);
    });
  });
});
