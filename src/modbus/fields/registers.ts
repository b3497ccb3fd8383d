import { defineField, type Field, type Seen } from '../field.ts';
import { FrameError } from '../frame-error.ts';
import { wholeNumber } from './number.ts';

/** 16-bit registers, each high byte first (AP 4.2), as an array of 0…65535; `size` tells their bytes. */
export function registers<N extends string>(name: N, size: (seen: Seen) => number): Field<N, readonly number[]> {
  return defineField<N, readonly number[]>(name, {
    kind: 'registers',
    size: (_bytes, _at, _end, seen) => size(seen),
    whole: (_bytes, at, to) => (to - at) & ~1,
    read: (bytes, from, to) => {
      const values = new Array<number>((to - from) >> 1);
      for (let i = 0, at = from; i < values.length; i++, at += 2) {
        values[i] = ((bytes[at] as number) << 8) | (bytes[at + 1] as number);
      }
      return values;
    },
    accept: (value, path) => acceptNumbers(value, path, 0xffff),
    length: (values) => 2 * values.length,
    write: (out, at, values) => {
      let next = at;
      for (let i = 0; i < values.length; i++) {
        const value = values[i] as number;
        out[next++] = value >>> 8;
        out[next++] = value & 0xff;
      }
    },
  });
}

/** Bytes as an array of 0…255; `size` tells their number. */
export function octets<N extends string>(name: N, size: (seen: Seen) => number): Field<N, readonly number[]> {
  return defineField<N, readonly number[]>(name, {
    kind: 'list',
    size: (_bytes, _at, _end, seen) => size(seen),
    read: (bytes, from, to) => Array.from(bytes.subarray(from, to)),
    accept: (value, path) => acceptNumbers(value, path, 0xff),
    length: (values) => values.length,
    write: (out, at, values) => out.set(values, at),
  });
}

function acceptNumbers(value: unknown, path: string, most: number): readonly number[] {
  const list = acceptList(value, path);
  for (let i = 0; i < list.length; i++) {
    const item = list[i] as number;
    if (item !== (item & most)) wholeNumber(item, `${path}[${i}]`, 0, most);
  }
  return list as readonly number[];
}

/** The value as a list; throws a `FrameError` for anything else. */
export function acceptList(value: unknown, path: string): readonly unknown[] {
  if (Array.isArray(value)) return value;
  throw new FrameError(path, value === undefined ? { code: 'field-missing' } : { code: 'not-a-list', got: value });
}
