import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
// @ts-expect-error: the script has no types of its own.
import { writeLog } from '../../../bench/field/write-log.mjs';
import { toHex } from '../../../src/modbus/index.ts';
import { readBytes } from '../../../src/notation/index.ts';
import { hex } from '../modbus/frames.ts';

interface Dialect {
  readonly name: string;
}

/** Bytes of one side; what is read has `-` if the dialect leaves the side open. */
interface Entry {
  readonly side: string;
  readonly bytes: Uint8Array;
}

const write: (
  dialect: Dialect,
  entries: readonly Entry[],
) => { readonly text: string; readonly chunks: readonly Entry[] } = writeLog;

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
  const { text, chunks } = write(dialect, said);
  const { bytes, chunks: read } = readBytes(text);
  const told = read.map(({ from, to, direction }, i) => [
    chunks[i]?.side === '-' ? '-' : direction,
    toHex(bytes.subarray(from, to)),
  ]);
  expect(told, text).toEqual(chunks.map(({ side, bytes }) => [side, toHex(bytes)]));
});
