import { isObject, isScalar, type Loose, numberOf, textOf } from './loose.ts';

const NAME_KEYS = ['name', 'label', 'text', 'title', 'desc', 'description', 'value', 'key', 'symbol'];
const NUMBER_KEYS = [
  'value',
  'key',
  'number',
  'code',
  'raw',
  'bit',
  'response',
  'id',
  'index',
  'position',
  'mask',
  'from',
];

/** Keys of numbers that do not name values. */
const PROPERTY =
  /^(?:scale|factor|offset|gain|min|max|bit|count|size|length|value|multiplier|divisor|precision|decimals|addr|reg|start|function)/i;

/** A list of numbers with names, such as the values of a register, as `0=Off; 1=On`; `undefined` of another list or map. */
export function namesText(value: unknown): string | undefined {
  if (isObject(value)) return mapText(value);
  if (!Array.isArray(value) || value.length === 0 || !value.every(isObject)) return undefined;
  const items: readonly Loose[] = value;
  const isNumber = (item: Loose, key: string) => numberOf(item[key]) !== undefined;
  const every = (key: string) => items.every((item) => Object.hasOwn(item, key) && isScalar(item[key]));
  const number = NUMBER_KEYS.find((key) => every(key) && items.every((item) => isNumber(item, key)));
  const name = NAME_KEYS.find((key) => key !== number && every(key) && !items.every((item) => isNumber(item, key)));
  if (number === undefined || name === undefined) return undefined;
  return items.map((item) => pair(item[number], item[name])).join('; ');
}

function mapText(value: Loose): string | undefined {
  const entries = Object.entries(value);
  if (entries.length === 0 || !entries.every(([, each]) => isScalar(each))) return undefined;
  if (entries.every(([key]) => numberOf(key) !== undefined))
    return entries.map(([key, each]) => pair(key, each)).join('; ');
  const numbers = entries.length > 1 && entries.every(([, each]) => numberOf(each) !== undefined);
  if (!numbers || entries.some(([key]) => PROPERTY.test(key))) return undefined;
  return entries.map(([key, each]) => pair(each, key)).join('; ');
}

const pair = (number: unknown, name: unknown): string =>
  `${textOf(number).trim()}=${textOf(name).trim().replace(/[\\;]/g, '\\$&')}`;
