import type { Name } from './code.ts';

/** The words of a name of a field: `startAddress` is `start address`. */
export const wordsOf = (camel: string): Name =>
  camel
    .replace(/([a-z\d])([A-Z])/g, '$1 $2')
    .toLowerCase()
    .trim();

const GERMAN: Readonly<Record<string, string>> = Object.assign(Object.create(null), {
  ß: 'ss',
  æ: 'ae',
  ø: 'o',
  đ: 'd',
  ł: 'l',
  µ: 'u',
  μ: 'u',
});

/**
 * Words of lower-case letters and digits out of anything that was typed: letters lose their accents, others end a word.
 * Empty if nothing is left.
 */
export const plainWords = (text: string): Name =>
  text
    .replace(/([a-z\d])([A-Z])/g, '$1 $2')
    .toLowerCase()
    .replace(/[ßæøđłµμ]/g, (letter) => GERMAN[letter] ?? '')
    .normalize('NFKD')
    .replace(/\p{M}/gu, '')
    .match(/[a-z\d]+/g)
    ?.join(' ') ?? '';

/** A name that nobody has yet: with a number, if need be. Takes it. */
export function fresh(taken: Set<Name>, wanted: Name): Name {
  let found = wanted;
  for (let number = 2; taken.has(found); number++) found = `${wanted} ${number}`;
  taken.add(found);
  return found;
}
