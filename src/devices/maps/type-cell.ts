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
  [/短整(?:型|数)/gu, ' short '],
  [/长整(?:型|数)/gu, ' long '],
  [/双精度(?:浮点数?)?/gu, ' double '],
  [
    /\b(?:ganzzahl\w*|entiere?|enter[oa]|inter[oa]|geheel getal|geheel|(?:liczba )?ca[łl]kowit\w*)|整数|整型/giu,
    ' int ',
  ],
  [
    /\b(?:gleitkomma\w*|fließkomma\w*|fliesskomma\w*|virgule flottante|flottante?|coma flotante|punto flotante|flotante|virgola mobile|drijvende komma|(?:liczba )?zmiennoprzecinkow\w*)|浮点数?|单精度/giu,
    ' float ',
  ],
  [/\b(?:zeichenkette|chaîne|cadena|stringa|tekenreeks|łańcuch|tekst|texte|testo|texto)|字符串?/giu, ' string '],
  [/\b(?:mots?|palabras?|parola|woord|słowo|wort)\b|字(?!符)/giu, ' word '],
  [/\b(?:booleano|booléen|boolesch|wahrheitswert)|布尔/giu, ' bool '],
  [/位/gu, ' bit '],
];
const OTHERS =
  /[^\0-\x7f]|vorz|zeichen|sign|gan|ent|int|geh|calk|liczba|gleit|flie|coma|virg|flot|drij|zmi|cade|strin|teken|tekst|text|mot|pala|paro|woord|wort|bool/i;

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

/** A type with more behind it: `u16/10`, `float (see note)`. */
export interface TypeStart extends TypeReading {
  /** What raw numbers are multiplied by, if the rest is a divisor. */
  readonly factor?: number;
}

/** Reads a type at the beginning of a text that says more; `undefined` if there is none. */
export function readTypeStart(text: string, registers?: number): TypeStart | undefined {
  const [, start = '', rest = ''] =
    /^([^(,;/÷*×]*[\p{L}\d\])])\s*([(,;/÷*×].*|(?<=\s)[\d.].*)$/u.exec(text.trim()) ?? [];
  const reading = start === '' ? undefined : readTypeCell(start, registers);
  const divisor = /^[/÷]\s*(10+)$/.exec(rest)?.[1];
  return reading && (divisor === undefined ? reading : { ...reading, factor: 1 / Number(divisor) });
}

/** `reserved[3]`, `INTERNAL[1]`: how many registers are left out. */
export const readGap = (text: string): number | undefined => {
  const [, count] = /^\p{L}+\s*[[(](\d{1,4})[\])]$/u.exec(text.trim()) ?? [];
  return count === undefined ? undefined : Number(count);
};

/** Digits from 0: makers count bytes from the first that is sent, or from the least significant one. */
const FROM_ZERO = /^(?:0\W?1\W?2\W?3|1\W?0\W?3\W?2|2\W?3\W?0\W?1|3\W?2\W?1\W?0)$/;

/** The order that a cell names: of bytes, of words, or of both; `undefined` if it names none, or one of two. */
export const readOrderCell = (text: string): Order | undefined =>
  text.trim() === '' || FROM_ZERO.test(text.trim())
    ? undefined
    : (readOrderName(text) ?? readOrderName(text.split(/[(,;]/)[0] ?? ''));

/** A format that says decimals, not a type: `DEC 1` is a whole number with one; `MAP INT` has names for its values. */
export function readFormat(text: string): { readonly factor: number } | undefined {
  const digits = /^dec(?:imal)?\.?[\s_]*(\d)$/i.exec(text.trim())?.[1];
  if (digits !== undefined) return { factor: 10 ** -Number(digits) };
  return /^map[\s_]*int$/i.test(text.trim()) ? { factor: 1 } : undefined;
}
