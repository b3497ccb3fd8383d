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

/** The chunks of a text, in the form of the vectors. */
function said(text: string): readonly string[] {
  const { bytes, chunks } = readBytes(text);
  return chunks.map(({ from, to, direction = '-' }) => `${direction}: ${formatBytes(bytes.subarray(from, to))}`);
}

test('there are as many as were collected', () => {
  expect(fieldLogs).toHaveLength(30);
});

test.each(fieldLogs.filter(({ expect: { chunks } }) => chunks !== undefined))('$id', ({ text, expect: { chunks } }) => {
  expect(said(text)).toEqual(chunks);
});

interface Variation {
  readonly kind: string;
  readonly name: string;
  readonly text: string;
  readonly chunks: readonly string[];
}

/** Other texts of the same kinds, each written before it was tried. */
const variations = JSON.parse(
  readFileSync(new URL('../../vectors/field-variations.json', import.meta.url), 'utf8'),
) as readonly Variation[];

test.each(variations)('$kind: $name', ({ text, chunks }) => {
  expect(said(text)).toEqual(chunks);
});
