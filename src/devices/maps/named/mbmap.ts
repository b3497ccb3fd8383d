import { isObject, isScalar, type Loose, numberOf, textOf, valueAt } from '../loose.ts';
import { factsOf, orderText, tableNamed } from '../object-facts.ts';
import { namesText } from '../object-names.ts';
import { type NamedFormat, type NamedRow, readHolding, readInput } from './named-format.ts';

const AREAS: readonly (readonly [RegExp, string])[] = [
  [/^(?:holding|4|hr)/i, readHolding],
  [/^(?:input|3|ir)/i, readInput],
  [/^(?:discrete|1|di)/i, 'discrete-input'],
  [/^(?:coil|0|co)/i, 'coil'],
];

/**
 * A file `.mbmap.json`, as `writeMbmap` writes it, and what is like it: where addresses begin and the order of words for the whole, the
 * area of each entry.
 */
export const mbmap: NamedFormat = {
  format: 'mbmap',
  read: (value) => {
    if (!isObject(value) || !/^mbmap/i.test(textOf(value['format']))) return undefined;
    const list = Object.values(value).find((each) => Array.isArray(each) && each.some(isEntry));
    if (!Array.isArray(list)) return undefined;
    return [{ facts: factsOf(value), rows: list.filter(isEntry).map(rowOf) }];
  },
};

const isEntry = (value: unknown): value is Loose => isObject(value) && 'area' in value && 'address' in value;

function rowOf(entry: Loose): NamedRow {
  const type = textOf(entry['type']);
  const area = textOf(entry['area']);
  const order = textOf(entry['wordOrder']);
  return {
    name: textOf(entry['name']),
    address: textOf(entry['address']),
    table: AREAS.find(([pattern]) => pattern.test(area))?.[1] ?? tableNamed(area) ?? area,
    type,
    order: orderText('wordorder', order),
    registers: textOf(entry['length']),
    count: textOf(entry['count']),
    factor: textOf(entry['scale']),
    offset: textOf(entry['offset']),
    scaleRegister: textOf(entry['scaleRegister']),
    decimals: textOf(entry['decimals']),
    unit: textOf(entry['unit']),
    access: textOf(entry['access']),
    names: namesText(entry['values'] ?? entry['bits']),
    mask: numberOf(valueAt(entry, 'mask')),
    notImplemented: textOf(entry['notImplemented']),
    group: textOf(entry['group']),
    model: textOf(entry['models']),
    description: isScalar(entry['description']) ? textOf(entry['description']) : '',
  };
}
