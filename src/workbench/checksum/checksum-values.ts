import { type CatalogueCrc, type Checksum, checksum, checksums, crcChecksum } from '../../modbus/index.ts';
import { type InputKind, type InputReading, readInput } from './checksum-input.ts';

/** The values of checksums by their names. */
export type ChecksumValues = Readonly<Record<string, number>>;

/** An input, how it was read, and the value of every named checksum over it. */
export interface DigestedInput {
  readonly reading: InputReading;
  readonly values: ChecksumValues;
}

/** Every named checksum of these bytes. */
export const checksumValues = (bytes: Uint8Array): ChecksumValues =>
  Object.fromEntries(checksums.map((one) => [one.name, checksum(one, bytes)]));

export function digestInput(text: string, as: InputKind): DigestedInput {
  const reading = readInput(text, as);
  return { reading, values: checksumValues(reading.bytes) };
}

/** An algorithm as a worker is told of it: by its name, or by its parameters if it has no name. */
export type ToldChecksum = string | CatalogueCrc;

/** How a checksum is told to a worker. */
export const tellChecksum = (one: Checksum): ToldChecksum =>
  checksums.includes(one) ? one.name : (one.crc ?? one.name);

/** The checksum that was told. Throws a `RangeError` for a name that no checksum has. */
export function toldChecksum(told: ToldChecksum): Checksum {
  if (typeof told !== 'string') return crcChecksum(told);
  const named = checksums.find(({ name }) => name === told);
  if (named === undefined) throw new RangeError(`no checksum ${told}`);
  return named;
}

/** A part of an input: the states of the checksums after it, and its size in bytes. */
export interface DigestedPart {
  readonly states: readonly number[];
  readonly size: number;
}

/** The values over all parts, in their order; the first was begun with each checksum's `start`, the others with 0. */
export function joinedValues(algorithms: readonly Checksum[], parts: readonly DigestedPart[]): ChecksumValues {
  const [first, ...others] = parts;
  return Object.fromEntries(
    algorithms.map((one, index) => {
      let state = first?.states[index] ?? one.start;
      for (const { states, size } of others) state = one.join?.(state, states[index] ?? 0, size) ?? state;
      return [one.name, one.value(state)];
    }),
  );
}
