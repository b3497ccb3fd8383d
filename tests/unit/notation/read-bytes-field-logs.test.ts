import { readFileSync } from 'node:fs';
import { expect, test } from 'vitest';
import { formatBytes, readBytes } from '../../../src/notation/index.ts';

interface FieldLog {
  readonly id: string;
  readonly text: string;
  readonly expect: { readonly chunks?: readonly string[] };
}

/** Logs as people have posted them, with the pieces that they hold: `side: bytes`. */
const fieldLogs = JSON.parse(
  readFileSync(new URL('../../vectors/field-logs.json', import.meta.url), 'utf8'),
) as readonly FieldLog[];

test('there are as many as were collected', () => {
  expect(fieldLogs).toHaveLength(30);
});

test.each(fieldLogs.filter(({ expect: { chunks } }) => chunks !== undefined))('$id', ({ text, expect: { chunks } }) => {
  const read = readBytes(text);
  const said = read.chunks.map(
    ({ from, to, direction = '-' }) => `${direction}: ${formatBytes(read.bytes.subarray(from, to))}`,
  );
  expect(said).toEqual(chunks);
});
