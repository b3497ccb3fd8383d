import { dictionary } from '../modbus/index.ts';

/**
 * What is read back from storage, where anything may stand: an older page, another program or a curious person wrote it.
 * A decoder takes a value out of JSON and answers it if it is legal, `undefined` if it is not.
 */
export type Decoder<T> = (stored: unknown) => T | undefined;

export const flag: Decoder<boolean> = (stored) => (typeof stored === 'boolean' ? stored : undefined);

/** A number from `least` to `most`. */
export const number =
  (least: number, most: number): Decoder<number> =>
  (stored) =>
    typeof stored === 'number' && stored >= least && stored <= most ? stored : undefined;

/** A whole number from `least` to `most`. */
export const whole = (least: number, most: number): Decoder<number> => {
  const decode = number(least, most);
  return (stored) => (Number.isInteger(stored) ? decode(stored) : undefined);
};

/** A text, if it is one that `accepts` allows. */
export const text =
  (accepts: (text: string) => boolean = () => true): Decoder<string> =>
  (stored) =>
    typeof stored === 'string' && accepts(stored) ? stored : undefined;

/** One of the values listed. */
export const oneOf =
  <T extends string | number | boolean>(values: readonly T[]): Decoder<T> =>
  (stored) =>
    values.find((value) => value === stored);

/** Those of the values listed that a stored list has, in the order of `values`. */
export const someOf =
  <T extends string | number>(values: readonly T[]): Decoder<readonly T[]> =>
  (stored) =>
    Array.isArray(stored) ? values.filter((value) => stored.includes(value)) : undefined;

/** A list, if all its items are legal. */
export const listOf =
  <T>(item: Decoder<T>): Decoder<readonly T[]> =>
  (stored) => {
    if (!Array.isArray(stored)) return undefined;
    const items = stored.map(item).filter((value) => value !== undefined);
    return items.length === stored.length ? items : undefined;
  };

/** Values by any name, also one that every object has; those that are not legal are left out. */
export const byName =
  <T>(item: Decoder<T>): Decoder<Readonly<Record<string, T>>> =>
  (stored) => {
    if (typeof stored !== 'object' || stored === null || Array.isArray(stored)) return undefined;
    return dictionary(
      Object.fromEntries(
        Object.entries(stored).flatMap(([name, value]) => {
          const decoded = item(value);
          return decoded === undefined ? [] : [[name, decoded]];
        }),
      ),
    );
  };

/**
 * Settings: each field by its decoder, or as in `defaults` where it is missing or not legal, so that the answer is always
 * complete and legal. Names that no field has are left out.
 */
export const record =
  <T extends object>(fields: { readonly [K in keyof T]-?: Decoder<T[K]> }, defaults: T) =>
  (stored: unknown): T => {
    const given = new Map(typeof stored === 'object' && stored !== null ? Object.entries(stored) : []);
    const names = Object.keys(fields) as (keyof T & string)[];
    return Object.fromEntries(
      names.map((name) => [name, fields[name](given.get(name)) ?? defaults[name]]),
    ) as unknown as T;
  };
