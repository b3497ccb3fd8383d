import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
// biome-ignore lint/correctness/useImportExtensions: its types stand in a file beside it.
import { type Dialect, type Entry, writeLog } from '../../../bench/field/write-log.mjs';
import { toHex } from '../../../src/modbus/index.ts';
import { readBytes } from '../../../src/notation/index.ts';
import { hex } from '../modbus/frames.ts';

const file = readFileSync(new URL('../../vectors/dialects.json', import.meta.url), 'utf8');
const dialects = JSON.parse(file) as readonly Dialect[];
/** Three exchanges. */
const said: readonly Entry[] = [
  { side: 'tx', bytes: hex('11 03 00 6B 00 03 76 87') },
  { side: 'rx', bytes: hex('11 03 06 02 2B 00 00 00 64 C8 BA') },
  { side: 'tx', bytes: hex('06 06 02 AB 10 00 F5 E5') },
  { side: 'rx', bytes: hex('06 06 02 AB 10 00 F5 E5') },
  { side: 'tx', bytes: hex('01 01 10 20 00 0F 79 04') },
  { side: 'rx', bytes: hex('01 01 02 00 12 39 F1') },
];

test.each(dialects.map((dialect) => [dialect.name, dialect] as const))('%s', (_, dialect) => {
  const { text, chunks } = writeLog(dialect, said);
  const { bytes, chunks: read } = readBytes(text);
  const told = read.map(({ from, to, direction }, i) => [
    chunks[i]?.side === '-' ? '-' : direction,
    toHex(bytes.subarray(from, to)),
  ]);
  expect(told, text).toEqual(chunks.map(({ side, bytes }) => [side, toHex(bytes)]));
});
