import { isObject, type Loose, numberOf, objectsIn, textOf, valueAt } from '../loose.ts';
import { namesText } from '../object-names.ts';
import { type NamedFormat, type NamedRow, type NamedTable, readHolding } from './named-format.ts';

/** Instances of a repeating group that are written out; a device may have more. */
const MOST_INSTANCES = 100;
const MOST_POINTS = 20_000;
const DEEPEST = 8;

/** The number of each type that says that a device has no such point (SunSpec Device Information Model Specification, 4.2.3). */
const NOT_IMPLEMENTED = new Map([
  ...['int16', 'sunssf'].map((type) => [type, '0x8000'] as const),
  ...['uint16', 'enum16', 'bitfield16'].map((type) => [type, '0xFFFF'] as const),
  ['int32', '0x80000000'],
  ...['uint32', 'enum32', 'bitfield32'].map((type) => [type, '0xFFFFFFFF'] as const),
  ['int64', '0x8000000000000000'],
  ...['uint64', 'bitfield64'].map((type) => [type, '0xFFFFFFFFFFFFFFFF'] as const),
  ...['float32', 'float64'].map((type) => [type, 'NaN'] as const),
]);

/**
 * Models of the SunSpec Alliance: https://github.com/sunspec/models. A model has no addresses: its points follow each other, and a
 * device says where the model begins, so that addresses here count from there (`relative`).
 */
export const sunspec: NamedFormat = {
  format: 'sunspec',
  read: (value) => {
    const models = [value, ...objectsIn(value), ...objectsIn(valueAt(value, 'models')), valueAt(value, 'model')].filter(
      isModel,
    );
    return models.length === 0 ? undefined : models.map(readModel);
  },
};

const isModel = (value: unknown): value is Loose => {
  const group = valueAt(value, 'group');
  return isObject(group) && objectsIn(group['points']).some((point) => 'type' in point && 'size' in point);
};

function readModel(model: Loose): NamedTable {
  const group = isObject(model['group']) ? model['group'] : {};
  const id = textOf(model['id']);
  const rows: NamedRow[] = [];
  let address = 0;
  walk(group, '', new Map(), 0);
  const device = [textOf(group['label']) || textOf(group['name']), id && `(${id})`].filter(Boolean).join(' ');
  return {
    name: device,
    facts: { table: readHolding, counting: 'zero', order: 'ABCD', relative: 'true', device },
    rows,
  };

  function walk(each: Loose, path: string, factors: ReadonlyMap<string, number>, depth: number): void {
    const points = objectsIn(each['points']);
    const own = new Map(factors);
    let next = address;
    for (const point of points) {
      if (textOf(point['type']) === 'sunssf') own.set(textOf(point['name']), next);
      next += sizeOf(point);
    }
    for (const point of points) {
      if (rows.length < MOST_POINTS) rows.push(rowOf(point, path, own));
      address += sizeOf(point);
    }
    if (depth === DEEPEST) return;
    for (const inner of objectsIn(each['groups'])) {
      const count = Math.min(MOST_INSTANCES, Math.max(1, numberOf(inner['count']) ?? 1));
      const repeats = inner['count'] !== undefined;
      for (let index = 1; index <= count && rows.length < MOST_POINTS; index++) {
        const name = textOf(inner['name']) + (repeats ? ` ${index}` : '');
        walk(inner, path === '' ? name : `${path} ${name}`, own, depth + 1);
      }
    }
  }

  function rowOf(point: Loose, path: string, factors: ReadonlyMap<string, number>): NamedRow {
    const scale = numberOf(point['sf']);
    const register = factors.get(textOf(point['sf']));
    const type = textOf(point['type']);
    const label = [textOf(point['label']), textOf(point['desc'])].filter(Boolean).join(': ');
    return {
      name: textOf(point['name']),
      address,
      type,
      registers: sizeOf(point),
      ...(scale === undefined ? {} : { factor: 10 ** scale }),
      scaleRegister: register,
      unit: textOf(point['units']),
      notImplemented: NOT_IMPLEMENTED.get(type),
      access: textOf(point['access']) || 'R',
      names: namesText(point['symbols']),
      group: path,
      description: label,
    };
  }
}

const sizeOf = (point: Loose): number => Math.max(1, Math.floor(numberOf(point['size']) ?? 1));
