import { type CatalogueCrc, type Checksum, checksum, checksums, crcChecksum } from '../../modbus/index.ts';
import { type InputKind, type InputReading, readInput } from '../../workbench/index.ts';

/** The values of checksums by their names. */
export type Values = Readonly<Record<string, number>>;

/** Bytes, how they were read, and the value of every named checksum over them. */
export interface Whole {
  readonly reading: InputReading;
  readonly values: Values;
}

/** An algorithm as it is told to a worker: by its name, or by its parameters where it has none. */
export type Told = string | CatalogueCrc;

/** What a worker is asked for: a text or a small file with all checksums, or a part of a large file with some. */
export type Task =
  | { readonly kind: 'text'; readonly text: string; readonly as: InputKind }
  | { readonly kind: 'file'; readonly file: Blob }
  | { readonly kind: 'part'; readonly file: Blob; readonly first: boolean; readonly algorithms: readonly Told[] };

export type Answer =
  | ({ readonly kind: 'whole' } & Whole)
  /** Bytes read since the last message. */
  | { readonly kind: 'progress'; readonly bytes: number }
  /** The states of the checksums after the part. */
  | { readonly kind: 'part'; readonly states: readonly number[] }
  | { readonly kind: 'failed' };

export const checksumOf = (told: Told): Checksum =>
  typeof told === 'string' ? (checksums.find(({ name }) => name === told) as Checksum) : crcChecksum(told);

/** How a checksum is told to a worker. */
export const tellOf = (one: Checksum): Told => (checksums.includes(one) ? one.name : (one.crc ?? one.name));

/** Every named checksum of these bytes. */
export const valuesOf = (bytes: Uint8Array): Values =>
  Object.fromEntries(checksums.map((one) => [one.name, checksum(one, bytes)]));

export function wholeOf(text: string, as: InputKind): Whole {
  const reading = readInput(text, as);
  return { reading, values: valuesOf(reading.bytes) };
}
