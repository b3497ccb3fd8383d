import { type Checksum, checksum, checksums, decodeFrame, fromHex, sameBytes, toHex } from '../../modbus/index.ts';
import { formatBytes, readNumber, writeTableText } from '../../notation/index.ts';
import type { Draft } from '../frame/draft.ts';
import { valueBytes } from './algorithm-rows.ts';
import { withoutChecksum } from './checked-bytes.ts';
import { type KnownSource, knownValues, type Printed } from './known-values.ts';
import { registerHex } from './register-text.ts';

/** Whether a printed value is the one that comes out here. */
export type Verdict = 'right' | 'swapped' | 'wrong';

/** A printed value beside the calculated one. */
export interface CardRow extends Omit<Printed, 'bytes'> {
  readonly bytes: Uint8Array;
  readonly checksum: Checksum;
  readonly value: number;
  readonly verdict: Verdict;
  readonly source: string;
}

const CRC = 'CRC-16/MODBUS';

/** The value as sources print one of this kind: a number, or the bytes as they are sent. */
export function printedAs(row: Pick<CardRow, 'as' | 'printed' | 'value' | 'checksum'>): string {
  const { as, printed, value, checksum: of } = row;
  if (as === 'wire') return formatBytes(valueBytes(value, of.width).toReversed());
  const hex = registerHex(of.width, value);
  return printed.startsWith('0x') ? hex : `${value}, ${hex}`;
}

function rowOf({ bytes: text, algorithm, printed, as }: Printed, source: string): CardRow[] {
  const of = checksums.find(({ name }) => name === algorithm);
  const bytes = fromHex(text);
  if (of === undefined || bytes === undefined) return [];
  const value = checksum(of, bytes);
  const right = valueBytes(value, of.width);
  // As a number is written, highest byte first.
  const got = as === 'wire' ? fromHex(printed)?.toReversed() : valueBytes(readNumber(printed) ?? 0, of.width);
  const verdict =
    got === undefined
      ? 'wrong'
      : sameBytes(got, right)
        ? 'right'
        : sameBytes(got, right.toReversed())
          ? 'swapped'
          : 'wrong';
  return [{ bytes, algorithm, printed, as, checksum: of, value, verdict, source }];
}

/** Values in print, each calculated again; `sources` are the names of their sources. */
export function cardRows(sources: Readonly<Record<KnownSource, string>>): readonly CardRow[] {
  return (Object.keys(knownValues) as KnownSource[]).flatMap((source) =>
    knownValues[source].flatMap((printed) => rowOf(printed, sources[source])),
  );
}

/** A frame that a source prints: what it means, and its bytes in hexadecimal. */
export interface PrintedFrame {
  readonly draft: Draft;
  readonly printed: string;
  /** What is wrong with the bytes printed, if anything is. */
  readonly fault?: string;
}

/** The RTU frames that the examples' sources print with a checksum; `names` are the names of the sources. */
export function exampleRows<Id extends string>(
  examples: readonly { readonly id: Id; readonly examples: readonly PrintedFrame[] }[],
  names: Readonly<Record<Id, string>>,
): readonly CardRow[] {
  return examples.flatMap(({ id, examples: frames }) =>
    frames.flatMap((frame) => {
      const printed = printedChecksum(frame);
      if (printed === undefined) return [];
      const rows = rowOf(printed, names[id]);
      return frame.fault === 'crc' ? rows : rows.filter(({ verdict }) => verdict !== 'wrong');
    }),
  );
}

/** The checksum that an RTU frame is printed with; `undefined` if it is printed without one. */
function printedChecksum({ draft: { transport, kind }, printed }: PrintedFrame): Printed | undefined {
  const bytes = fromHex(printed);
  if (transport !== 'rtu' || bytes === undefined) return undefined;
  const reading = decodeFrame(bytes, { transport, direction: kind === 'request' ? 'request' : 'response' });
  const body = withoutChecksum(reading, bytes);
  return body.length === bytes.length
    ? undefined
    : { bytes: toHex(body), algorithm: CRC, printed: formatBytes(bytes.subarray(body.length)), as: 'wire' };
}

/** Rows as comma-separated values, with the values that come out here. */
export function cardCsv(rows: readonly CardRow[], head: readonly string[]): string {
  const lines = rows.map((row) => [
    formatBytes(row.bytes),
    row.algorithm,
    row.printed,
    registerHex(row.checksum.width, row.value),
    row.verdict,
    row.source,
  ]);
  return writeTableText([head, ...lines], 'csv');
}

/** The right CRC-16/MODBUS values as an array in C to test an implementation against. */
export function cardC(rows: readonly CardRow[]): string {
  const ofModbus = rows.filter(({ algorithm }) => algorithm === CRC);
  const distinct = [...new Map(ofModbus.map((row) => [toHex(row.bytes), row])).values()];
  const longest = Math.max(1, ...distinct.map(({ bytes }) => bytes.length));
  const list = (bytes: Uint8Array) => (toHex(bytes).match(/../g) ?? []).map((pair) => `0x${pair}`).join(', ');
  const lines = distinct.map(
    ({ bytes, value }) => `  { ${bytes.length}, { ${list(bytes)} }, ${registerHex(16, value)} },`,
  );
  return [
    '/* CRC-16/MODBUS; on the wire the low byte goes first. */',
    `static const struct { uint8_t length; uint8_t bytes[${longest}]; uint16_t crc; } modbus_crc_tests[] = {`,
    ...lines,
    '};',
  ].join('\n');
}
