import { computed, type ReadonlySignal } from '@preact/signals-core';

/** What `read` answers, which must be plain data. While it says the same, its readers are not told. */
export function steady<T>(read: () => T): ReadonlySignal<T> {
  let held: T | undefined;
  return computed(() => {
    const value = read();
    if (held === undefined || !same(held, value)) held = value;
    return held as T;
  });
}

/** Whether two values of plain data are the same. What is no plain data, such as a function, is the same as itself only. */
export function same(one: unknown, other: unknown): boolean {
  if (Object.is(one, other)) return true;
  if (typeof one !== 'object' || typeof other !== 'object' || one === null || other === null) return false;
  if (Array.isArray(one) !== Array.isArray(other)) return false;
  const [names, others] = [Object.keys(one), Object.keys(other)];
  return (
    names.length === others.length &&
    names.every((name) => Object.hasOwn(other, name) && same(Reflect.get(one, name), Reflect.get(other, name)))
  );
}
