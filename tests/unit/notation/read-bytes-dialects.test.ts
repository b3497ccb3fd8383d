import { expect, test } from 'vitest';
import { toHex } from '../../../src/modbus/index.ts';
import { readBytes } from '../../../src/notation/index.ts';
import { dialects, said, write } from './dialects.ts';

test.each(dialects)('%s', (_, dialect) => {
  const { text, chunks } = write(dialect, said);
  const { bytes, chunks: read } = readBytes(text);
  const told = read.map(({ from, to, direction }, i) => [
    chunks[i]?.side === '-' ? '-' : direction,
    toHex(bytes.subarray(from, to)),
  ]);
  expect(told, text).toEqual(chunks.map(({ side, bytes }) => [side, toHex(bytes)]));
});
