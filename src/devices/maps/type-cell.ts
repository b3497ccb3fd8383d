import type { Order } from '../../modbus/index.ts';
import { readOrderName, readTypeName, type TypeReading } from '../../notation/index.ts';

/** Words of types in other languages, as English has them. */
const WORDS: readonly (readonly [RegExp, string])[] = [
  [
    /\b(?:vorzeichenlos\w*|ohne vorzeichen|non sign[eé]e?|sans signe|sin signo|senza segno|zonder teken|bez znaku)|无符号/giu,
    ' unsigned ',
  ],
  [
    /\b(?:mit vorzeichen|vorzeichenbehaftet\w*|avec signe|con signo|con segno|met teken|ze znakiem)|有符号/giu,
    ' signed ',
  ],
  [/(?<![\p{L}])sign[eé]e?(?!\p{L})/giu, ' signed '],
  [/\b(?:ganzzahl\w*|entiere?|enter[oa]|inter[oa]|geheel getal|geheel|całkowit\w*|calkowit\w*)|整数|整型/giu, ' int '],
  [
    /\b(?:gleitkomma\w*|fließkomma\w*|fliesskomma\w*|virgule flottante|flottante?|coma flotante|punto flotante|flotante|virgola mobile|drijvende komma|zmiennoprzecinkow\w*)|浮点数?|单精度/giu,
    ' float ',
  ],
  [/\b(?:zeichenkette|chaîne|cadena|stringa|tekenreeks|łańcuch|tekst|texte|testo|texto)|字符串?/giu, ' string '],
  [/\b(?:mots?|palabras?|parola|woord|słowo|wort)\b|字(?!符)/giu, ' word '],
  [/\b(?:booleano|booléen|boolesch|wahrheitswert)|布尔/giu, ' bool '],
  [/位/gu, ' bit '],
];
const OTHERS =
  /[^\0-\x7f]|vorz|zeichen|sign|gan|ent|int|geh|calk|gleit|flie|coma|virg|flot|drij|zmi|cade|strin|teken|tekst|text|mot|pala|paro|woord|wort|bool/i;

/** Reads a type under a name of masters, of programs, or of a language; `registers` is the length that the table gives. */
export function readTypeCell(text: string, registers?: number): TypeReading | undefined {
  if (text.length > 80) return undefined;
  const plain = text.replace(/[\u00a0\s]+/g, ' ').trim();
  const found = readTypeName(plain, registers);
  if (found || !OTHERS.test(plain)) return found;
  let translated = plain;
  for (const [pattern, word] of WORDS) translated = translated.replace(pattern, word);
  return translated === plain ? undefined : readTypeName(translated.replace(/\s+/g, ' '), registers);
}

/** `reserved[3]`, `INTERNAL[1]`: how many registers are left out. */
export const readGap = (text: string): number | undefined => {
  const [, count] = /^\p{L}+\s*[[(](\d{1,4})[\])]$/u.exec(text.trim()) ?? [];
  return count === undefined ? undefined : Number(count);
};

/** The order that a cell names: of bytes, of words, or of both. */
export const readOrderCell = (text: string): Order | undefined =>
  text.trim() === '' ? undefined : (readOrderName(text) ?? readOrderName(text.split(/[(,;]/)[0] ?? ''));

/** A format that says decimals, not a type: `DEC 1` is a whole number with one; `MAP INT` has names for its values. */
export function readFormat(text: string): { readonly factor: number } | undefined {
  const digits = /^dec(?:imal)?\.?[\s_]*(\d)$/i.exec(text.trim())?.[1];
  if (digits !== undefined) return { factor: 10 ** -Number(digits) };
  return /^map[\s_]*int$/i.test(text.trim()) ? { factor: 1 } : undefined;
}
