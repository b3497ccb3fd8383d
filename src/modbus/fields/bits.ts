import { defineField, type Field, type Seen } from '../field.ts';
import { FrameError } from '../frame-error.ts';
import { bytesOfBits, wholeNumber } from './number.ts';
import { acceptList } from './registers.ts';

type Bit = 0 | 1;

/** The value as 0 or 1, from these or from true and false; throws a `FrameError` for anything else. */
export function acceptFlag(value: unknown, path: string): Bit {
  if (value === 1 || value === true) return 1;
  if (value === 0 || value === false) return 0;
  throw new FrameError(path, value === undefined ? { code: 'field-missing' } : { code: 'not-a-flag', got: value });
}

interface BitParts {
  /** The bytes the bits take. */
  readonly size: (seen: Seen) => number;
  /** How many bits there are, if the frame or its request says so; else all bits of the bytes count. */
  readonly quantity: (seen: Seen) => number | undefined;
}

/**
 * Coils or inputs, eight a byte, the first in the lowest bit of the first byte, as an array of 0 and 1. Unused high bits of
 * the last byte should be zero (AP 6.1, AP 6.11); if they are not, they are kept as the forced value `padding`.
 */
export function bits<N extends string>(name: N, { size, quantity }: BitParts): Field<N, readonly Bit[]> {
  return defineField<N, readonly Bit[]>(name, {
    kind: 'bits',
    size: (_bytes, _at, _end, seen) => size(seen),
    read: (bytes, from, to, seen) => {
      const length = to - from;
      const asked = quantity(seen);
      // A quantity that contradicts the bytes says nothing about them.
      const many = asked !== undefined && bytesOfBits(asked) === length ? asked : 8 * length;
      const values = new Array<Bit>(many);
      for (let i = 0; i < many; i++) values[i] = (((bytes[from + (i >> 3)] as number) >> (i & 7)) & 1) as Bit;
      const padding = many % 8 === 0 ? 0 : (bytes[to - 1] as number) >> (many % 8);
      if (padding !== 0) seen.force('padding', padding);
      return values;
    },
    rules: [
      (values, seen) => {
        const padding = seen.forced['padding'];
        return typeof padding === 'number' && values.length % 8 !== 0
          ? { code: 'padding-not-zero', severity: 'warning', got: padding }
          : undefined;
      },
    ],
    accept: (value, path) => {
      const list = acceptList(value, path);
      return list.map((bit, i) => acceptFlag(bit, `${path}[${i}]`));
    },
    length: (values) => bytesOfBits(values.length),
    write: (out, at, values, force) => {
      for (let i = 0; i < values.length; i++) {
        const index = at + (i >> 3);
        const before = (i & 7) === 0 ? 0 : (out[index] as number);
        out[index] = before | ((values[i] as Bit) << (i & 7));
      }
      const padding = force?.['padding'];
      if (padding !== undefined && values.length % 8 !== 0) {
        const last = at + (values.length >> 3);
        const used = values.length % 8;
        out[last] = (out[last] as number) | (wholeNumber(padding, 'padding', 0, 0xff >> used) << used);
      }
    },
  });
}

/** The two legal coil values (AP 6.5). */
const COIL_ON = 0xff00;
const COIL_OFF = 0x0000;

/** A coil's state as it is sent. */
export const rawCoil = (value: boolean): number => (value ? COIL_ON : COIL_OFF);

/**
 * A coil: `true` is equivalent to ON, 1 and FF00, `false` to OFF, 0 and 0000. Anything else is illegal and without
 * effect on the coil (AP 6.5), though some devices take every value but 0 as ON; it is kept as the forced `rawValue`.
 */
export function coil<N extends string>(name: N): Field<N, boolean> {
  return defineField<N, boolean>(name, {
    kind: 'flag',
    width: 2,
    read: (bytes, from, _to, seen) => {
      const raw = ((bytes[from] as number) << 8) | (bytes[from + 1] as number);
      if (raw !== COIL_ON && raw !== COIL_OFF) seen.force('rawValue', raw);
      return raw !== COIL_OFF;
    },
    rules: [
      (_value, { forced }) => {
        const raw = forced['rawValue'];
        return typeof raw === 'number' ? { code: 'coil-value-illegal', severity: 'error', got: raw } : undefined;
      },
    ],
    replyRules: [
      (value, { forced, request }) => {
        const asked = request?.derived['rawValue'];
        const raw = forced['rawValue'] ?? rawCoil(value);
        return asked === undefined || asked === raw
          ? undefined
          : { code: 'echo-differs', severity: 'error', field: name };
      },
    ],
    accept: (value, path) => acceptFlag(value, path) === 1,
    write: (out, at, value, force) => {
      const forced = force?.['rawValue'];
      const raw = forced !== undefined ? wholeNumber(forced, 'rawValue', 0, 0xffff) : rawCoil(value);
      out[at] = raw >>> 8;
      out[at + 1] = raw & 0xff;
    },
  });
}
