import { type Checksum, checksum, checksums, fromHex, sameBytes, toHex } from '../../modbus/index.ts';
import { formatBytes, formatHex, readNumber } from '../../notation/index.ts';
import type { Misprint } from '../../words/index.ts';
import type { ExampleSource } from '../examples/examples.ts';
import { type KnownSource, knownValues, type Printed } from './known-values.ts';

/** Whether a printed value is the one that comes out here. */
export type Verdict = 'right' | 'swapped' | 'wrong';

/** A printed value beside the one worked out. */
export interface CardRow extends Omit<Printed, 'bytes'> {
  readonly bytes: Uint8Array;
  readonly checksum: Checksum;
  readonly value: number;
  readonly verdict: Verdict;
  readonly source: string;
}

const CRC = 'CRC-16/MODBUS';
const CRC_SIZE = 2;

/** The bytes of a value, highest first. */
const bytesOf = (value: number, width: number) => fromHex(formatHex(value, width / 4).slice(2)) ?? new Uint8Array();

/** The value as sources print one of this kind: a number, or the bytes as they are sent. */
export function printedAs(row: Pick<CardRow, 'as' | 'printed' | 'value' | 'checksum'>): string {
  const { as, printed, value, checksum: of } = row;
  if (as === 'wire') return formatBytes(bytesOf(value, of.width).toReversed());
  const hex = formatHex(value, of.width / 4);
  return printed.startsWith('0x') ? hex : `${value}, ${hex}`;
}

function rowOf({ bytes: text, algorithm, printed, as }: Printed, source: string): CardRow[] {
  const of = checksums.find(({ name }) => name === algorithm);
  const bytes = fromHex(text);
  if (of === undefined || bytes === undefined) return [];
  const value = checksum(of, bytes);
  const right = bytesOf(value, of.width);
  // As a number is written, highest byte first.
  const got = as === 'wire' ? fromHex(printed)?.toReversed() : bytesOf(readNumber(printed) ?? 0, of.width);
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

/** Values in print, each worked out anew; `sources` are the names of where they stand. */
export function cardRows(sources: Readonly<Record<KnownSource, string>>): readonly CardRow[] {
  return (Object.keys(knownValues) as KnownSource[]).flatMap((source) =>
    knownValues[source].flatMap((printed) => rowOf(printed, sources[source])),
  );
}

/** The RTU frames that the examples' sources print with a checksum. */
export function exampleRows(
  examples: readonly ExampleSource[],
  names: Readonly<Record<ExampleSource['id'], string>>,
): readonly CardRow[] {
  return examples.flatMap(({ id, examples: frames }) =>
    frames.flatMap(({ draft, printed, fault }) => {
      const frame = fromHex(printed);
      // What is printed without a checksum has nothing to be compared.
      if (draft.transport !== 'rtu' || frame === undefined || frame.length <= CRC_SIZE) return [];
      const rows = rowOf(ofFrame(frame), names[id]);
      return fault === 'crc' ? rows : rows.filter(({ verdict }) => verdict !== 'wrong');
    }),
  );
}

const ofFrame = (frame: Uint8Array): Printed => ({
  bytes: toHex(frame, 0, frame.length - CRC_SIZE),
  algorithm: CRC,
  printed: formatBytes(frame.subarray(-CRC_SIZE)),
  as: 'wire',
});

/** The misprints that are a frame whose checksum alone is wrong. */
export function misprintRows(misprints: readonly Misprint[]): readonly CardRow[] {
  return misprints.flatMap(({ printed, right, where }) => {
    const [one, other] = [printed, right].map(readFrame);
    if (one === undefined || other === undefined || one.bytes !== other.bytes) return [];
    return rowOf(one, where).filter(({ verdict }) => verdict !== 'right');
  });
}

/** A frame that stands alone in a text: RTU in pairs, or ASCII behind its colon. */
function readFrame(text: string): Printed | undefined {
  const ascii = /^:([0-9A-F]+)$/.exec(text)?.[1];
  const frame = fromHex(ascii ?? text);
  if (frame === undefined || frame.length <= CRC_SIZE) return undefined;
  if (ascii === undefined) return ofFrame(frame);
  const end = frame.length - 1;
  return { bytes: toHex(frame, 0, end), algorithm: 'LRC', printed: `0x${toHex(frame, end)}`, as: 'number' };
}

/** Rows as comma-separated values, with the values that come out here. */
export function cardCsv(rows: readonly CardRow[], head: readonly string[]): string {
  const quoted = (text: string) => (/[",\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text);
  const lines = rows.map((row) => [
    formatBytes(row.bytes),
    row.algorithm,
    row.printed,
    formatHex(row.value, row.checksum.width / 4),
    row.verdict,
    row.source,
  ]);
  return [head, ...lines].map((cells) => cells.map(quoted).join(',')).join('\n');
}

/** The right CRC-16/MODBUS values as an array in C to run one's own implementation against. */
export function cardC(rows: readonly CardRow[]): string {
  const ofModbus = rows.filter(({ algorithm }) => algorithm === CRC);
  const distinct = [...new Map(ofModbus.map((row) => [toHex(row.bytes), row])).values()];
  const longest = Math.max(1, ...distinct.map(({ bytes }) => bytes.length));
  const list = (bytes: Uint8Array) => (toHex(bytes).match(/../g) ?? []).map((pair) => `0x${pair}`).join(', ');
  const lines = distinct.map(
    ({ bytes, value }) => `  { ${bytes.length}, { ${list(bytes)} }, ${formatHex(value, 4)} },`,
  );
  return [
    '/* CRC-16/MODBUS; on the wire the low byte goes first. */',
    `static const struct { uint8_t length; uint8_t bytes[${longest}]; uint16_t crc; } modbus_crc_tests[] = {`,
    ...lines,
    '};',
  ].join('\n');
}
