import { isObject, type Loose, numberOf, objectsIn, textOf } from '../loose.ts';
import { namesText } from '../object-names.ts';
import { type NamedFormat, type NamedRow, type NamedTable, tableOfFunction } from './named-format.ts';

/** The sign and registers of a number, or what else it is. */
type Kind = readonly ['u' | 'i', number] | string;

/** What a value is, by its rule; a value of several registers names them from the least significant one on. */
const TYPES: ReadonlyMap<number, Kind> = new Map<number, Kind>([
  [1, ['u', 1]],
  [2, ['i', 1]],
  [3, ['u', 2]],
  [4, ['i', 2]],
  [5, 'text'],
  [6, 'bits'],
  [8, 'timeymd'],
]);

/**
 * Definitions of inverters for the Solarman integration of Home Assistant: https://github.com/StephanJoubert/home_assistant_solarman.
 * `requests` names the ranges that are read and their functions. A value is (raw − offset) × scale.
 */
export const solarman: NamedFormat = {
  format: 'solarman',
  read: (value) => {
    const groups = objectsIn(isObject(value) ? value['parameters'] : undefined);
    const requests = objectsIn(isObject(value) ? value['requests'] : undefined);
    const tables = groups.flatMap((group): NamedTable[] => {
      const items = objectsIn(group['items']).filter((item) => 'rule' in item && Array.isArray(item['registers']));
      const rows = items.map((item) => rowOf(item, requests, textOf(group['group'])));
      return rows.length === 0 ? [] : [{ facts: { counting: 'zero' }, rows }];
    });
    return tables.length === 0 ? undefined : tables;
  },
};

function rowOf(item: Loose, requests: readonly Loose[], group: string): NamedRow {
  const list = (Array.isArray(item['registers']) ? item['registers'] : []).map(numberOf);
  const numbers = list.flatMap((number) => number ?? []);
  const type = TYPES.get(numberOf(item['rule']) ?? 0);
  const isRising = numbers.every((number, at) => number === (numbers[0] ?? 0) + at);
  const isFalling = numbers.every((number, at) => number === (numbers[0] ?? 0) - at);
  const scale = numberOf(item['scale']);
  const offset = numberOf(item['offset']);
  const isText = type === 'text';
  return {
    name: textOf(item['name']),
    // Registers that do not follow each other are no value.
    address: isRising || isFalling ? Math.min(...numbers) : textOf(item['registers']),
    table: tableAt(Math.min(...numbers), requests),
    type: typeof type === 'string' ? type : type && `${type[0]}${16 * Math.max(type[1], numbers.length)}`,
    order: numbers.length < 2 || isText ? '' : isRising ? 'CDAB' : 'ABCD',
    registers: isText ? numbers.length : '',
    factor: scale,
    offset: offset === undefined ? '' : -offset * (scale ?? 1),
    unit: textOf(item['uom']),
    names: namesText(item['lookup']),
    mask: textOf(item['mask']),
    group,
  };
}

/** The table from which a request reads an address; `undefined` if none does, or several of different tables. */
function tableAt(address: number, requests: readonly Loose[]): string | undefined {
  const found = requests.filter(
    ({ start, end }) => address >= (numberOf(start) ?? 0) && address <= (numberOf(end) ?? -1),
  );
  const tables = new Set(found.map((request) => tableOfFunction(numberOf(request['mb_functioncode']))));
  return tables.size === 1 ? [...tables][0] : undefined;
}
