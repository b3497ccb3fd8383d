import { isFilled } from './cell-kinds.ts';
import type { MapNoticeCode } from './codes.ts';
import type { MapRow } from './map-row.ts';
import type { MapColumn, Meaning } from './meaning.ts';
import { decimal, type ScaleCell } from './scale-cell.ts';

export type Direction = 'multiply' | 'divide';

/** In which direction the numbers of a scale go. */
export interface ScaleChoice {
  /** Of bare numbers; of `x10` and its like. */
  readonly plain: Direction;
  readonly times: Direction;
  /** A person has to say: neither the header, nor the numbers, nor an example in a text does. */
  readonly asked: ReadonlySet<ScaleCell['kind']>;
  /** The first row whose scale is in doubt. */
  readonly first?: MapRow;
}

/** Units of which hardly anybody counts in tens and more. */
const FINE = /^(?:°|deg|℃|[cfkvav%]$|v |a |mv|hz|bar|mbar|psi|m\/s|pf|cos|ph|m$|l\/|min|h$|s$|kwh|kw$|kva|kvar)/i;

/** Finds out what the numbers of a scale do, from headers, cells, and examples such as `490 = 49.0 °C`. */
export function scaleChoice(
  rows: readonly MapRow[],
  columns: readonly MapColumn[],
  answer: string | undefined,
): ScaleChoice {
  if (answer === 'multiply' || answer === 'divide') return { plain: answer, times: answer, asked: new Set() };
  const header = columns.find(({ meaning }) => meaning === 'factor')?.header ?? '';
  const scaled = rows.flatMap((row) => {
    const cell = row.read.scale(row.text('factor'));
    return cell && Math.abs(cell.number) !== 1 && cell.kind !== 'divided' ? [{ row, cell }] : [];
  });
  const of = (kind: ScaleCell['kind']) => scaled.filter(({ cell }) => cell.kind === kind);
  const plain = direction(of('plain'), header);
  const times = direction(of('times'), header);
  const asked = new Set([...(plain.asked ? (['plain'] as const) : []), ...(times.asked ? (['times'] as const) : [])]);
  const first = (plain.asked && (of('plain').find(isBig) ?? of('plain')[0])) || (times.asked && of('times')[0]);
  return { plain: plain.way, times: times.way, asked, ...(first ? { first: first.row } : {}) };
}

interface Scaled {
  readonly row: MapRow;
  readonly cell: ScaleCell;
}
const isBig = ({ cell }: Scaled): boolean => Math.abs(cell.number) > 1;

function direction(scaled: readonly Scaled[], header: string): { readonly way: Direction; readonly asked: boolean } {
  if (scaled.length === 0) return { way: 'multiply', asked: false };
  const votes = { multiply: 0, divide: 0 };
  for (const one of scaled) {
    const way = exampleOf(one);
    if (way) votes[way]++;
  }
  if (votes.multiply !== votes.divide)
    return {
      way: votes.multiply > votes.divide ? 'multiply' : 'divide',
      asked: votes.multiply > 0 && votes.divide > 0,
    };
  const big = scaled.filter(isBig);
  if (big.length === 0) return { way: 'multiply', asked: false };
  const isNamed = /accura|resol|genauig|aufl|precis|lsb|step|schritt|精度|分辨率/i.test(header);
  if (isNamed) return { way: 'multiply', asked: false };
  const fine = big.filter(({ row }) => FINE.test(row.read.unit(row.text('unit')).unit));
  // The word factor means what it means everywhere else.
  if (
    /^(?:factor|faktor|facteur|fattore|mno[zż]nik|multiplier|multiplikator|multiplicateur|multiplicador|moltiplicatore|vermenigvuldiger)$/i.test(
      header.trim(),
    )
  )
    return { way: 'multiply', asked: true };
  const divides = big.length > scaled.length / 2 && fine.length >= big.length / 2;
  return { way: divides ? 'divide' : 'multiply', asked: true };
}

const EXAMPLE =
  /([-−]?\d{1,8}(?:[.,]\d{1,6})?)\s*(?:\p{L}{0,12}\s*)?(?:=|≙|->|→|means|entspricht|corresponds to|equals|is|~)\s*([-−]?\d{1,8}(?:[.,]\d{1,6})?)/gu;

/** The direction that a text beside a scale shows: `490 = 49.0 °C`, `50~350 (5,0~35,0 °C)`. */
function exampleOf({ row, cell }: Scaled): Direction | undefined {
  const text = [...row.texts('description'), row.text('name'), ...row.texts('range'), ...row.texts('unit')]
    .join(' ')
    .slice(0, 500);
  if (!/[=≙→>~(]|means|entspr|corresp|equals|is/.test(text)) return undefined;
  const factor = cell.number;
  const pairs = [...text.matchAll(EXAMPLE)].map(([, raw = '', value = '']) => [decimal(raw), decimal(value)] as const);
  const range = /(\d[\d.,]*)\s*[-~…–]+\s*(\d[\d.,]*)\s*\(\s*(\d[\d.,]*)\s*[-~…–]+\s*(\d[\d.,]*)/.exec(text);
  if (range) pairs.push([decimal(range[2] ?? ''), decimal(range[4] ?? '')]);
  for (const [raw, value] of pairs) {
    if (raw === 0 || value === 0) continue;
    if (isNear(value, raw * factor)) return 'multiply';
    if (isNear(value, raw / factor)) return 'divide';
  }
  return undefined;
}

const isNear = (one: number, other: number): boolean => Math.abs(one - other) <= 1e-6 * Math.abs(other);

/** The factor and unit of a row, and what of it could not be read. */
export interface RowScale {
  readonly factor: number;
  readonly offset: number;
  readonly unit: string;
  readonly decimals?: number;
  readonly notices: readonly MapNoticeCode[];
  /** The name or address of the register with the exponent. */
  readonly register?: string;
  /** The direction of the factor is a guess. */
  readonly doubtful: boolean;
}

export interface ScaleRules {
  readonly choice: ScaleChoice;
  /** The table has a column of factors or divisors. */
  readonly hasScale: boolean;
  /** Decimals scale a whole number. */
  readonly decimalsScale: boolean;
}

/** Reads factor, offset and unit of a row; `isFloat` says that its values have decimals of their own. */
export function rowScale(row: MapRow, { choice, decimalsScale, hasScale }: ScaleRules, isFloat: boolean): RowScale {
  const notices: MapNoticeCode[] = [];
  const filled = (meaning: Meaning) => (isFilled(row.text(meaning)) ? row.text(meaning) : '');
  const scaleText = filled('factor');
  const cell = row.read.scale(scaleText);
  const register =
    filled('scale-register') ||
    (scaleText !== '' && !cell && /^[\p{L}_][\p{L}\d_]*$/u.test(scaleText) ? scaleText : '');
  let factor = 1;
  if (cell) factor = turned(cell, choice);
  else if (scaleText !== '' && register === '') notices.push('factor-unreadable');
  const divisor = row.read.scale(filled('divisor'));
  if (divisor)
    factor =
      (divisor.kind === 'divided' && divisor.number < 1 ? divisor.number : 1 / divisor.number) * (cell ? factor : 1);
  else if (filled('divisor') !== '') notices.push('factor-unreadable');
  const power = filled('exponent');
  const exponent = power === '' ? Number.NaN : decimal(power);
  if (Number.isInteger(exponent)) factor *= 10 ** exponent;
  const unitText = row.text('unit');
  // Names of values stand in the column of units, too.
  const { unit, scale } = row.read.unit(cell?.unit ?? (row.read.pairs(unitText).names.length > 0 ? '' : unitText));
  if (scale && !cell && !divisor && !Number.isInteger(exponent) && !isFloat)
    factor = scale.kind === 'times' ? turned(scale, choice) : scale.number;
  const decimalsText = filled('decimals');
  const decimals = /^\d{1,2}$/.test(decimalsText) ? Number(decimalsText) : undefined;
  if (decimals !== undefined && decimals > 0 && decimalsScale && !isFloat && !cell && !divisor && !scale)
    factor /= 10 ** decimals;
  const range = row
    .texts('range')
    .map(row.read.range)
    .find((one) => one !== undefined);
  const silent = scaleText === '' && decimals === undefined && !scale && register === '' && !hasScale && !isFloat;
  if (range?.factor !== undefined && silent) {
    factor = range.factor;
    notices.push('factor-from-range');
  }
  const offsetText = filled('offset');
  const offset = offsetText === '' ? 0 : decimal(offsetText);
  if (Number.isNaN(offset)) notices.push('offset-unreadable');
  return {
    factor,
    offset: Number.isNaN(offset) ? 0 : offset,
    unit: unit === '' ? (range?.unit ?? '') : unit,
    ...(decimals === undefined || decimals > 10 ? {} : { decimals }),
    notices,
    ...(register === '' ? {} : { register }),
    doubtful: cell !== undefined && choice.asked.has(cell.kind) && Math.abs(cell.number) !== 1,
  };
}

const turned = ({ kind, number }: ScaleCell, { plain, times }: ScaleChoice): number =>
  kind === 'divided' || (kind === 'plain' ? plain : times) === 'multiply' ? number : 1 / number;
