import { saysNothing } from './cell-words.ts';

/** A factor as a cell has it. */
export interface ScaleCell {
  readonly number: number;
  /** `plain` is a bare number, `divided` is `/10` or `1/10`, `times` is `x10`, whose direction nobody knows. */
  readonly kind: 'plain' | 'divided' | 'times';
  /** What follows the number: `0.1 °C`. */
  readonly unit?: string;
  readonly offset?: number;
}

const NUMBER = String.raw`[-+−]?(?:\d+(?:[.,]\d+)?|[.,]\d+)(?:e[-+]?\d+)?`;
const SUPERSCRIPTS = '⁰¹²³⁴⁵⁶⁷⁸⁹';

/** A decimal number with point or comma; `NaN` for any other text. */
export const decimal = (text: string): number =>
  Number(
    text
      .trim()
      .replace('−', '-')
      .replace(',', '.')
      .replace(/^([-+]?)\./, '$10.'),
  );

const FORMS: readonly (readonly [RegExp, ScaleCell['kind'], (a: number, b: number) => number])[] = [
  [new RegExp(`^(${NUMBER})$`, 'i'), 'plain', (a) => a],
  [new RegExp(`^(${NUMBER})\\s*[/:÷]\\s*(${NUMBER})$`, 'i'), 'divided', (a, b) => a / b],
  [new RegExp(`^(?:value|raw|wert|val|n|x)?\\s*[/÷:]\\s*(${NUMBER})$`, 'i'), 'divided', (a) => 1 / a],
  [new RegExp(`^(?:value|raw|wert|val|n|x)\\s*[*×·∙]\\s*(${NUMBER})$`, 'i'), 'divided', (a) => a],
  [
    new RegExp(`^(?:divided? by|div\\.?|geteilt durch|dividiert durch|divis[eé] par)\\s*(${NUMBER})$`, 'i'),
    'divided',
    (a) => 1 / a,
  ],
  [new RegExp(`^(?:value|raw|wert|val)?\\s*[x×*·∙]\\s*(${NUMBER})$`, 'i'), 'times', (a) => a],
  [new RegExp(`^(${NUMBER})\\s*[x×*·∙]$`, 'i'), 'times', (a) => a],
  [new RegExp(`^(?:lsb|1 ?bit|1 ?digit|1)\\s*=\\s*(${NUMBER})$`, 'i'), 'divided', (a) => a],
  [new RegExp(`^(${NUMBER})\\s*=\\s*1(?:[.,]0+)?$`, 'i'), 'divided', (a) => 1 / a],
  // Formats of SMA: FIX2 has two decimals, RAW and ENUM none.
  [/^fix(\d)$/i, 'divided', (a) => 10 ** -a],
  [/^(?:raw|enum)$/i, 'divided', () => 1],
  [/^10\s*(?:\^|\*\*|e)\s*\(?([-−+]?\d+)\)?$/i, 'divided', (a) => 10 ** a],
];

/** `1,000` among scales that have no decimal comma is one thousand. */
export const withoutGroups = (text: string): string =>
  /^\s*\d{1,3}(?:,000)+\s*$/.test(text) ? text.replaceAll(',', '') : text;

/** Reads a factor: `0.1`, `.5`, `0,1`, `1/10`, `/10`, `x10`, `10^-1`, `10⁻²`, `1e-3`, `LSB = 0.1`; `undefined` for any other text. */
export function readScaleCell(text: string): ScaleCell | undefined {
  const plain = text
    .replace(
      /10([⁻⁺]?)([⁰¹²³⁴-⁹]+)/g,
      (_, sign: string, power: string) =>
        `10^${sign === '⁻' ? '-' : ''}${[...power].map((digit) => SUPERSCRIPTS.indexOf(digit)).join('')}`,
    )
    .replace(/^[(\s]+|[)\s]+$/g, '');
  if (plain === '') return undefined;
  for (const [pattern, kind, numberOf] of FORMS) {
    const found = pattern.exec(plain);
    if (!found) continue;
    const number = numberOf(decimal(found[1] ?? ''), decimal(found[2] ?? '1'));
    return Number.isFinite(number) && number !== 0 ? { number, kind } : undefined;
  }
  const withUnit = new RegExp(
    `^(${NUMBER}(?:\\s*[/÷]\\s*\\d+)?|[/÷]\\s*\\d+|[x×*]\\s*\\d+)\\s*([^\\d\\s].{0,20})$`,
    'iu',
  ).exec(plain);
  if (!withUnit || saysNothing(withUnit[2] as string)) return undefined;
  const inner = readScaleCell(withUnit[1] as string);
  return inner && { ...inner, unit: (withUnit[2] as string).replace(/\s*\/\s*(?:bit|digit|lsb|count)$/i, '').trim() };
}

/** A unit as a cell has it, and a factor before or behind it: `0.1V`, `V x 0.1`, `°C (÷10)`. */
export function readUnitCell(text: string): { readonly unit: string; readonly scale?: ScaleCell } {
  const plain = text.replace(/\s+/g, ' ').trim();
  if (saysNothing(plain) || /^(?:[YMDhms]{2,}|bool|boolean|enum|text|string|bit|hex)$/.test(plain)) return { unit: '' };
  const bracketed = /^[[(]([^)\]]+)[)\]]$/.exec(plain);
  if (bracketed) return readUnitCell(bracketed[1] as string);
  const behind = /^(\D+?)\s*[([]?\s*((?:[x×*·/÷]\s*)?\d[\d.,/eE^-]*)\s*[)\]]?$/u.exec(plain);
  const scale =
    behind && /[x×*·/÷([\s]/.test(plain.slice((behind[1] as string).length))
      ? readScaleCell(behind[2] as string)
      : undefined;
  if (behind && scale) return { unit: (behind[1] as string).trim(), scale };
  const before = /^(?:\d|[x×*/÷.]\s*\d)/.test(plain) ? readScaleCell(plain) : undefined;
  if (before?.unit !== undefined)
    return {
      unit: before.unit,
      scale: { number: before.number, kind: before.kind === 'plain' ? 'divided' : before.kind },
    };
  return before === undefined ? { unit: plain } : { unit: '', scale: before };
}
