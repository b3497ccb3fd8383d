import type { ReadNews, Wanted } from '../../bus/index.ts';
import {
  canRead,
  type FoundRegister,
  isBitTable,
  type Profile,
  powerIn,
  rawOf,
  valuesOf,
} from '../../devices/index.ts';
import type { Value } from '../../modbus/index.ts';
import { type LineValue, wantedValues } from './wanted-values.ts';

/** Why there is no value. */
export type ReadFailure = Pick<ReadNews, 'outcome' | 'verdict' | 'exceptionCode' | 'unsure'>;

export const failureOf = ({ outcome, verdict, exceptionCode, unsure }: ReadFailure): ReadFailure => ({
  outcome,
  verdict,
  ...(exceptionCode !== undefined && { exceptionCode }),
  ...(unsure !== undefined && { unsure }),
});

/** What was read last at a place: registers or bits, or why there are none. The time is in milliseconds since 1970. */
export interface ReadCell {
  readonly time: number;
  readonly items?: readonly number[] | undefined;
  readonly failure?: ReadFailure | undefined;
}

/** What was read of a device, by place. It holds registers and no values, so that an edited line shows its value at once. */
export type ReadCells = ReadonlyMap<string, ReadCell>;

/** Where what was read of a value is kept. */
export const readKey = ({ table, address, size }: Wanted): string => `${table} ${address} ${size}`;

/** The values of lines that can be read, as they are asked for. */
export const readableValues = (found: readonly FoundRegister[]): readonly LineValue[] =>
  found.filter(({ register }) => canRead(register)).flatMap((each) => indicesOf(each));

const indicesOf = ({ register, index }: FoundRegister, most = Number.POSITIVE_INFINITY): LineValue[] =>
  index === undefined
    ? Array.from({ length: Math.min(most, valuesOf(register)) }, (_, each) => ({ register, index: each }))
    : [{ register, index }];

/** A value that was read; `raw` is `undefined` if the registers hold none of its type, `power` if its power of ten is not known. */
export type MapValue =
  | {
      readonly kind: 'value';
      readonly raw: Value | undefined;
      readonly power: number | undefined;
      readonly time: number;
    }
  | { readonly kind: 'failed'; readonly failure: ReadFailure; readonly time: number };

/** Values of a line that are shown in its row. */
const SHOWN = 4;

/** The first values of a line, as far as they were read. */
export function mapValues(profile: Profile, found: FoundRegister, cells: ReadCells): readonly MapValue[] {
  if (cells.size === 0) return [];
  const values = indicesOf(found, SHOWN);
  const { wanted, powers } = wantedValues(profile, values, 1);
  const cellOf = (place: number | undefined) => {
    const of = place === undefined ? undefined : wanted[place];
    return of && cells.get(readKey(of));
  };
  return values.flatMap(({ register }, place): MapValue[] => {
    const cell = cellOf(place);
    if (cell === undefined) return [];
    const { items, failure, time } = cell;
    if (items === undefined) return failure ? [{ kind: 'failed', failure, time }] : [];
    const raw = isBitTable(register.table) ? items[0] : rawOf(items, register);
    return [{ kind: 'value', raw, power: powerIn(cellOf(powers[place])?.items?.[0]), time }];
  });
}

/** How a reading stands. */
export interface ReadingProgress {
  /** Requests. */
  readonly done: number;
  readonly left: number;
  /** Values. */
  readonly read: number;
  readonly failed: number;
  /** All that were to be read. */
  readonly wanted: number;
}
