import { type Loose, numberOf, objectsIn, textOf, valueAt } from '../loose.ts';
import { type NamedFormat, type NamedRow, type NamedTable, readHolding, readInput } from './named-format.ts';

const LISTS = {
  coils: 'coil',
  discrete_inputs: 'discrete-input',
  input_registers: readInput,
  holding_registers: readHolding,
} as const;

const TABLES = new Map([
  ['coil', 'coil'],
  ['discrete', 'discrete-input'],
  ['input', readInput],
  ['holding', readHolding],
]);

/** Fixed-point types take their width from the number of addresses; `FLOAT32` is the old name of one. */
const FIXED = new Map([
  ['FIXED', 'INT'],
  ['UFIXED', 'UINT'],
  ['FLOAT32', 'UINT'],
]);

/**
 * The input plug-in `modbus` of Telegraf, by register, request or metric:
 * https://github.com/influxdata/telegraf/tree/master/plugins/inputs/modbus.
 */
export const telegraf: NamedFormat = {
  format: 'telegraf',
  read: (value) => {
    const plugins = objectsIn(valueAt(valueAt(value, 'inputs'), 'modbus'));
    return plugins.length === 0 ? undefined : plugins.map(readPlugin);
  },
};

function readPlugin(plugin: Loose): NamedTable {
  const device = textOf(plugin['name']);
  const requests = [...objectsIn(plugin['request']), ...objectsIn(plugin['metric'])];
  const units = new Set([plugin, ...requests].map((each) => textOf(each['slave_id'])).filter(Boolean));
  const [unit = ''] = units;
  return {
    ...(device === '' ? {} : { name: device }),
    facts: { counting: 'zero', ...(device === '' ? {} : { device }), ...(units.size === 1 ? { unit } : {}) },
    rows: [
      ...Object.entries(LISTS).flatMap(([list, table]) =>
        objectsIn(plugin[list]).map((field) => registerRow(field, table)),
      ),
      ...requests.flatMap((request) => objectsIn(request['fields']).map((field) => fieldRow(field, request))),
    ],
  };
}

function registerRow(field: Loose, table: string): NamedRow {
  const addresses = (Array.isArray(field['address']) ? field['address'] : [field['address']]).map(numberOf);
  const type = textOf(field['data_type']).toUpperCase();
  const fixed = FIXED.get(type);
  return {
    name: textOf(field['name']),
    address: addresses[0],
    table,
    type:
      table === readHolding || table === readInput
        ? fixed
          ? `${fixed}${addresses.length * 16}`
          : plainType(type)
        : 'bool',
    order: textOf(field['byte_order']),
    registers: type === 'STRING' ? addresses.length : '',
    factor: textOf(field['scale']),
    bit: textOf(field['bit']),
    group: textOf(field['measurement']),
  };
}

function fieldRow(field: Loose, request: Loose): NamedRow {
  const table = TABLES.get(textOf(field['register'] ?? request['register'])) ?? readHolding;
  const isBit = table === 'coil' || table === 'discrete-input';
  return {
    name: textOf(field['name']),
    address: textOf(field['address']),
    table,
    type: isBit ? 'bool' : plainType(textOf(field['type'])),
    order: isBit ? '' : textOf(request['byte_order']) || 'ABCD',
    registers: textOf(field['length']),
    factor: textOf(field['scale']),
    bit: textOf(field['bit']),
    group: textOf(field['measurement'] ?? request['measurement']),
  };
}

const plainType = (type: string): string => type.replace(/-IEEE$/i, '');
