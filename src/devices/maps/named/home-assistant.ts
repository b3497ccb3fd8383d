import { dictionary } from '../../../modbus/index.ts';
import { isObject, type Loose, numberOf, objectsIn, textOf, valueAt } from '../loose.ts';
import { namesText } from '../object-names.ts';
import { type NamedFormat, type NamedRow, type NamedTable, readHolding, readInput } from './named-format.ts';

/** Kinds of entities with the table they have if none is said. */
const KINDS: Readonly<Record<string, string>> = dictionary({
  sensors: readHolding,
  binary_sensors: 'coil',
  switches: readHolding,
  lights: readHolding,
  fans: readHolding,
  covers: readHolding,
  climates: readHolding,
});

const TABLES: Readonly<Record<string, string>> = dictionary({
  holding: readHolding,
  input: readInput,
  coil: 'coil',
  coils: 'coil',
  discrete_input: 'discrete-input',
  holdings: readHolding,
});

const ORDERS: Readonly<Record<string, string>> = dictionary({ byte: 'BADC', word: 'CDAB', word_byte: 'DCBA' });

/** The `modbus:` part of a configuration of Home Assistant, alone or in the whole: https://www.home-assistant.io/integrations/modbus/. */
export const homeAssistant: NamedFormat = {
  format: 'home-assistant',
  read: (value) => {
    const own = isObject(value) ? (value['modbus'] ?? packagesOf(value)) : value;
    const hubs = (Array.isArray(own) ? objectsIn(own) : isObject(own) ? [own] : []).filter(isHub);
    return hubs.length === 0 ? undefined : hubs.flatMap(readHub);
  },
};

/** A package file has a name above its `modbus:`. */
const packagesOf = (value: Loose): unknown => {
  const found = Object.values(value)
    .map((each) => valueAt(each, 'modbus'))
    .filter((each) => each !== undefined);
  return found.length === 0 ? value : found.flat();
};

const isHub = (hub: Loose): boolean =>
  Object.keys(KINDS).some((kind) =>
    objectsIn(hub[kind]).some((entity) => 'address' in entity && ('name' in entity || 'unique_id' in entity)),
  );

/** The devices of a hub: a table for each unit. */
function readHub(hub: Loose): NamedTable[] {
  const entities = Object.keys(KINDS).flatMap((kind) => objectsIn(hub[kind]).map((entity) => ({ kind, entity })));
  const name = textOf(hub['name']);
  const line = lineOf(hub);
  return [...new Set(entities.map(({ entity }) => unitOf(entity)))].map((unit) => ({
    ...(name === '' ? {} : { name }),
    facts: {
      counting: 'zero',
      // What is not swapped has the high byte of the first register first.
      order: 'ABCD',
      ...(name === '' ? {} : { device: name }),
      ...(unit === '' ? {} : { unit }),
      ...(line === undefined ? {} : { line }),
    },
    rows: entities.flatMap(({ kind, entity }) => (unitOf(entity) === unit ? rowsOf(kind, entity) : [])),
  }));
}

const PARITIES: Readonly<Record<string, string>> = dictionary({ N: 'none', E: 'even', O: 'odd' });

/** The serial line of a hub that has one, as the facts of a table have it. */
function lineOf(hub: Loose): string | undefined {
  if (textOf(hub['type']) !== 'serial') return undefined;
  const [baud, bits, stop] = ['baudrate', 'bytesize', 'stopbits'].map((key) => textOf(hub[key]));
  return [baud, bits, PARITIES[textOf(hub['parity']).toUpperCase()] ?? '', stop].join(',');
}

const unitOf = (entity: Loose): string => textOf(entity['device_address'] ?? entity['slave']);

function rowsOf(kind: string, entity: Loose): NamedRow[] {
  const name = textOf(entity['name'] ?? entity['unique_id']);
  const table = TABLES[textOf(entity['input_type'] ?? entity['write_type'])] ?? KINDS[kind];
  const isBit = table === 'coil' || table === 'discrete-input';
  const custom = textOf(entity['data_type']) === 'custom';
  const type = custom ? textOf(entity['structure']) : textOf(entity['data_type']) || 'int16';
  const repeats = numberOf(entity['virtual_count'] ?? entity['slave_count']);
  const shared = {
    order: ORDERS[textOf(entity['swap'])],
    factor: textOf(entity['scale']),
    offset: textOf(entity['offset']),
    decimals: textOf(entity['precision']),
    unit: textOf(entity['unit_of_measurement'] ?? entity['temperature_unit']),
    group: kind,
  };
  const own: NamedRow = {
    ...(kind === 'sensors' || kind === 'climates' ? shared : { group: shared.group }),
    name,
    address: textOf(entity['address']),
    table,
    type: isBit ? 'bool' : type,
    registers: custom || type === 'string' ? textOf(entity['count']) : '',
    notImplemented: textOf(entity['nan_value']),
    count: repeats === undefined ? '' : repeats + 1,
    // Templates of other integrations name values beside what Home Assistant knows.
    names: kind === 'sensors' ? namesText(entity['map'] ?? entity['options']) : commands(entity),
  };
  return [own, ...(kind === 'climates' ? climateRows(entity, name, type, shared) : [])];
}

function commands(entity: Loose): string {
  const [on, off] = [entity['command_on'], entity['command_off']].map(textOf);
  return [off && `${off}=off`, on && `${on}=on`].filter(Boolean).join('; ');
}

function climateRows(entity: Loose, name: string, type: string, shared: NamedRow): NamedRow[] {
  const target = entity['target_temp_register'];
  const rows: NamedRow[] = (Array.isArray(target) ? target.slice(0, 1) : target === undefined ? [] : [target]).map(
    (address) => ({
      ...shared,
      name: `${name} target`,
      address: textOf(address),
      table: readHolding,
      type,
    }),
  );
  for (const [key, word] of [
    ['hvac_mode_register', 'mode'],
    ['fan_mode_register', 'fan mode'],
    ['swing_mode_register', 'swing mode'],
  ] as const) {
    const register = entity[key];
    if (!isObject(register)) continue;
    rows.push({
      name: `${name} ${word}`,
      address: textOf(register['address']).split(',')[0],
      table: readHolding,
      type: 'uint16',
      names: namesText(register['values']),
      group: shared.group,
    });
  }
  const power = entity['hvac_onoff_register'];
  if (power !== undefined)
    rows.push({ name: `${name} on`, address: textOf(power), table: readHolding, type: 'uint16', group: shared.group });
  return rows;
}
