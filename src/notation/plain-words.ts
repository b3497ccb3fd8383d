/** How letters are spelled that are not a letter of ASCII with a mark, and those that German spells with two. */
const SPELLED: ReadonlyMap<string, string> = new Map(
  Object.entries({ ä: 'ae', ö: 'oe', ü: 'ue', ß: 'ss', æ: 'ae', œ: 'oe', ø: 'o', đ: 'd', ł: 'l', µ: 'u', μ: 'u' }),
);

const spelled = (letter: string): string => {
  const small = letter.toLowerCase();
  const text = SPELLED.get(small) ?? letter;
  return small === letter ? text : text.charAt(0).toUpperCase() + text.slice(1);
};

/** A text with the letters of ASCII for those of Latin: `Größe` is `Groesse`, `é` is `e`. Other letters stay. */
export const latinLetters = (text: string): string =>
  text
    .normalize('NFC')
    .replace(/[^\0-\x7f]/g, spelled)
    .normalize('NFKD')
    .replace(/\p{M}/gu, '');

/**
 * Words of lower-case letters and digits out of anything that was typed: `SetSpeed` is two, Latin letters become those of ASCII, and
 * others end a word. Empty if nothing is left.
 */
export const plainWords = (text: string): string =>
  latinLetters(text.replace(/([\p{Ll}\d])(\p{Lu})/gu, '$1 $2').toLowerCase())
    .match(/[a-z\d]+/g)
    ?.join(' ') ?? '';
