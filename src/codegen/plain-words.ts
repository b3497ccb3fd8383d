import type { Name } from './code.ts';

/** The words of a name of a field: `startAddress` is `start address`. */
export const wordsOf = (camel: string): Name =>
  camel
    .replace(/([a-z\d])([A-Z])/g, '$1 $2')
    .toLowerCase()
    .trim();

/** A name that nobody has yet: with a number, if need be. Takes it. */
export function fresh(taken: Set<Name>, wanted: Name): Name {
  let found = wanted;
  for (let number = 2; taken.has(found); number++) found = `${wanted} ${number}`;
  taken.add(found);
  return found;
}
