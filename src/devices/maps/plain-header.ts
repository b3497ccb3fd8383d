import { latinLetters } from '../../notation/index.ts';

/** A header as it is looked up: small letters of ASCII and Chinese, digits, and single blanks; `Reg._Adr. (hex)` is `reg adr hex`. */
export const plainHeader = (text: string): string =>
  text.trim() === '#'
    ? '#'
    : latinLetters(text.replace(/([\p{Ll}\d])(\p{Lu}\p{Ll})/gu, '$1 $2'))
        .toLowerCase()
        .replace(/[^a-z\d\u4e00-\u9fff]+/g, ' ')
        .trim();
