import { dictionary } from '../../../modbus/index.ts';
import { isObject, type Loose, numberOf, objectsIn, textOf } from '../loose.ts';
import { namesText } from '../object-names.ts';
import { type NamedFormat, type NamedRow, readHolding, readInput } from './named-format.ts';

const TABLES: Readonly<Record<string, string>> = dictionary({
  holding: readHolding,
  read: readInput,
  coil: 'coil',
  discrete_input: 'discrete-input',
});

/** Sensors, numbers, switches … of the platform `modbus_controller`: https://esphome.io/components/modbus_controller. */
export const esphome: NamedFormat = {
  format: 'esphome',
  read: (value) => {
    if (!isObject(value)) return undefined;
    const rows = Object.entries(value).flatMap(([component, list]) =>
      objectsIn(list)
        .filter((entity) => textOf(entity['platform']) === 'modbus_controller' && 'address' in entity)
        .map((entity) => rowOf(component, entity)),
    );
    return rows.length === 0 ? undefined : [{ facts: { counting: 'zero' }, rows }];
  },
};

function rowOf(component: string, entity: Loose): NamedRow {
  const table = TABLES[textOf(entity['register_type'])] ?? readHolding;
  const isBit = table === 'coil' || table === 'discrete-input';
  const isText = component === 'text_sensor';
  // Where the value begins in the reply: bytes of registers, or bits.
  const inReply = numberOf(entity['offset']) ?? 0;
  const address = (numberOf(entity['address']) ?? 0) + (isBit ? inReply : Math.floor(inReply / 2));
  const valueType = textOf(entity['value_type']);
  return {
    name: textOf(entity['name'] ?? entity['id']),
    address: inReply === 0 ? textOf(entity['address']) : address,
    table,
    type: isBit ? 'bool' : isText ? 'string' : valueType === 'RAW' || valueType === '' ? 'U_WORD' : valueType,
    registers: isText ? textRegisters(entity) : '',
    ...scaleOf(entity),
    decimals: textOf(entity['accuracy_decimals']),
    unit: textOf(entity['unit_of_measurement']),
    mask: textOf(entity['bitmask']),
    names: namesText(entity['optionsmap']),
    group: component,
  };
}

function textRegisters(entity: Loose): number | string {
  const bytes = numberOf(entity['response_size']);
  return bytes === undefined ? textOf(entity['register_count']) : Math.ceil(bytes / 2);
}

/** A number is multiplied before it is written; the filters of a sensor follow each other. */
function scaleOf(entity: Loose): Pick<NamedRow, 'factor' | 'divisor' | 'offset'> {
  if (entity['multiply'] !== undefined) return { divisor: textOf(entity['multiply']) };
  let factor = 1;
  let offset = 0;
  for (const filter of objectsIn(entity['filters'])) {
    const times = numberOf(filter['multiply']) ?? 1;
    factor = tidy(factor * times);
    offset = tidy(offset * times + (numberOf(filter['offset']) ?? 0));
  }
  return { ...(factor === 1 ? {} : { factor }), ...(offset === 0 ? {} : { offset }) };
}

const tidy = (value: number): number => Number(value.toPrecision(12));
