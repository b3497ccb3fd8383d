import { dateText } from '../../modbus/index.ts';

/** Formats that a workbook names by number and does not write out (ECMA-376-1 18.8.30), as far as they change how digits are read. */
const BUILT_IN: Readonly<Record<number, string>> = {
  2: '0.00',
  4: '0.00',
  9: '0%',
  10: '0.00%',
  14: 'd',
  15: 'd',
  16: 'd',
  17: 'd',
  18: 'h',
  19: 'h',
  20: 'h',
  21: 'h',
  22: 'd h',
  45: 'm:s',
  46: 'h',
  47: 'm:s',
};

const EPOCH_1900 = 25_569;
const DAYS_1904 = 1462;
const SECONDS = 86_400;

/**
 * A number of a cell as its format shows it: zeros in front (`0064`), a percent sign, words around it, dates as `2024-02-29 13:00:00`.
 * Digits are neither rounded nor grouped.
 */
export function shownNumber(text: string, format: number | string, from1904: boolean): string {
  const value = Number(text);
  if (text.trim() === '' || !Number.isFinite(value)) return text;
  const code = typeof format === 'number' ? (BUILT_IN[format] ?? '') : format;
  const [section = ''] = code.split(';');
  const words: string[] = [];
  const shape = section
    .replace(/\[[^\]hms][^\]]*\]/gi, '')
    .replace(/"([^"]*)"|\\(.)|[_*]./g, (whole, quoted?: string, escaped?: string) => {
      if (whole.startsWith('_') || whole.startsWith('*')) return '';
      words.push(quoted ?? escaped ?? '');
      return '\uE000';
    });
  if (/[ydhs]|m.*[:/]|^m/i.test(shape) && !/general/i.test(shape))
    return shownDate(value + (from1904 ? DAYS_1904 : 0), shape);
  if (!/[0#?]/.test(shape)) return plainNumber(value);
  const number = digitsText(value, shape);
  let word = 0;
  const [before = ''] = /^\uE000*/.exec(shape.trimStart()) ?? [];
  const front = [...before].map(() => words[word++] ?? '').join('');
  return front + number + words.slice(word).join('');
}

function digitsText(value: number, shape: string): string {
  if (/e[+-]/i.test(shape) || shape.includes('/')) return plainNumber(value);
  const percent = shape.includes('%');
  const [, whole = '', part = ''] =
    /([0#?,]*)(?:\.([0#?]*))?/.exec(shape.slice(Math.max(0, shape.search(/[0#?.]/)))) ?? [];
  const [digits = '', decimals = ''] = plainNumber(percent ? value * 100 : value).split('.');
  const sign = digits.startsWith('-') ? '-' : '';
  const least = whole.replace(/[^0]/g, '').length;
  const padded = sign + digits.slice(sign.length).padStart(least, '0');
  const places = decimals.padEnd(part.replace(/[^0]/g, '').length, '0');
  return padded + (places === '' ? '' : `.${places}`) + (percent ? '%' : '');
}

/** Fifteen digits, as a spreadsheet has them, without an exponent. */
function plainNumber(value: number): string {
  const short = String(Number(value.toPrecision(15)));
  if (!short.includes('e')) return short;
  const [mantissa = '', exponent = ''] = short.split('e');
  const places = Number(exponent);
  return places > 0
    ? BigInt(Math.round(value)).toString()
    : value.toFixed(Math.min(100, (mantissa.split('.')[1] ?? '').length - places));
}

const two = (value: number): string => String(value).padStart(2, '0');

function shownDate(serial: number, shape: string): string {
  const whole = Math.floor(serial);
  const seconds = Math.round((serial - whole) * SECONDS);
  const time = `${two(Math.floor(seconds / 3600))}:${two(Math.floor(seconds / 60) % 60)}:${two(seconds % 60)}`;
  const hasDate = /[yd]/i.test(shape) || !/[hs]/i.test(shape);
  if (!hasDate) return time;
  return /h/i.test(shape) ? `${dateText(whole - EPOCH_1900)} ${time}` : dateText(whole - EPOCH_1900);
}
