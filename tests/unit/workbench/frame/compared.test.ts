import { expect, test } from 'vitest';
import { compareFrames } from '../../../../src/diagnosis/index.ts';
import { comparedBlocks } from '../../../../src/workbench/frame/compared.ts';

const bytes = (text: string) => Uint8Array.from(text.split(' '), (pair) => Number.parseInt(pair, 16));

test('the bytes of two frames stand above each other, field by field, in pieces that fit', () => {
  const mine = bytes('11 10 00 6B 00 02 04 03 E8 00 02 12 34');
  const theirs = bytes('11 10 00 6B 00 02 04 03 E8 00 03 12 34');
  const { runs } = compareFrames(mine, theirs, { transport: 'rtu', direction: 'request' });
  const blocks = comparedBlocks(runs, 2);
  expect(blocks.map(({ name, columns }) => [name, columns.map(({ mine: at }) => at)])).toEqual([
    ['unitId', [0]],
    ['functionCode', [1]],
    ['startAddress', [2, 3]],
    ['quantity', [4, 5]],
    ['byteCount', [6]],
    ['registers', [7, 8]],
    ['registers', [9, 10]],
    ['checksum', [11, 12]],
  ]);
  const different = blocks.flatMap(({ columns }) => columns).filter(({ kind }) => kind !== 'equal');
  expect(different.map(({ mine: at, theirs: there }) => [at, there])).toEqual([[10, 10]]);
});

test('a byte that one frame lacks has none above or below it', () => {
  const run = { name: 'registers', fieldKind: 'registers', kind: 'missing' } as const;
  const runs = [{ ...run, mineFrom: 7, mineTo: 9, theirsFrom: 7, theirsTo: 8 }] as unknown as Parameters<
    typeof comparedBlocks
  >[0];
  expect(comparedBlocks(runs, 8)[0]?.columns.map(({ mine, theirs }) => [mine, theirs])).toEqual([
    [7, 7],
    [8, undefined],
  ]);
});
