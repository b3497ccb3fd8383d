import { isObject, type Loose, numberOf, objectsIn, textOf, valueAt } from '../loose.ts';
import { type NamedFormat, type NamedRow, type NamedTable, tableOfFunction } from './named-format.ts';

const LISTS = ['timeseries', 'attributes', 'attributeUpdates', 'rpc'] as const;
const DEEPEST = 8;

/** `modbus.json` of the gateway of ThingsBoard: https://thingsboard.io/docs/iot-gateway/config/modbus/. */
export const thingsboard: NamedFormat = {
  format: 'thingsboard',
  read: (value) => {
    const devices = devicesIn(value, 0);
    return devices.length === 0 ? undefined : devices.map(readDevice);
  },
};

const hasTags = (value: Loose): boolean =>
  LISTS.some((list) => objectsIn(value[list]).some((row) => 'tag' in row && 'address' in row && 'functionCode' in row));

function devicesIn(value: unknown, depth: number): readonly Loose[] {
  if (depth === DEEPEST) return [];
  if (Array.isArray(value)) return value.flatMap((each) => devicesIn(each, depth + 1));
  if (!isObject(value)) return [];
  if (hasTags(value)) return [value];
  return Object.values(value).flatMap((each) => devicesIn(each, depth + 1));
}

function readDevice(device: Loose): NamedTable {
  const rows = LISTS.flatMap((list) => objectsIn(device[list]).map((row) => rowOf(row, list)));
  const name = textOf(device['deviceName']);
  const unit = textOf(device['unitId']);
  const order = orderOf(device);
  return {
    ...(name === '' ? {} : { name }),
    facts: {
      counting: 'zero',
      ...(order === undefined ? {} : { order }),
      ...(name === '' ? {} : { device: name }),
      ...(unit === '' ? {} : { unit }),
    },
    rows,
  };
}

/** The two orders that all versions of the gateway take to mean the same. */
function orderOf(device: Loose): string | undefined {
  const [byte, word] = ['byteOrder', 'wordOrder'].map((key) => textOf(valueAt(device, key)).toUpperCase());
  if (byte !== 'BIG') return undefined;
  return word === 'BIG' ? 'ABCD' : word === 'LITTLE' ? 'CDAB' : undefined;
}

function rowOf(row: Loose, list: string): NamedRow {
  const code = numberOf(row['functionCode']);
  const isWritten = code !== undefined && code > 4;
  const type = textOf(row['type']).replace(/^(\d+)(\w+)$/, '$2$1');
  const isText = /^(?:string|bytes)$/.test(type);
  const table = tableOfFunction(code);
  const isBit = table === 'coil' || table === 'discrete-input';
  return {
    name: textOf(row['tag']),
    address: textOf(row['address']),
    table,
    type: isBit ? 'bool' : type,
    registers: isText || /^(?:int|uint)$/.test(type) ? textOf(row['objectsCount']) : '',
    count: isBit ? textOf(row['objectsCount']) : '',
    factor: textOf(row['multiplier']),
    divisor: textOf(row['divider']),
    access: isWritten ? 'w' : 'r',
    bit: type === 'bits' && !isBit ? textOf(row['bit']) : '',
    group: list,
  };
}
