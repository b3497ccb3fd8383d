import { isObject, type Loose, numberOf, objectsIn, textOf, valueAt } from '../loose.ts';
import { namesText } from '../object-names.ts';
import type { NamedFormat, NamedRow, NamedTable } from './named-format.ts';

/** `…-registers.json` of the plug-ins of nymea: https://github.com/nymea/nymea-plugins-modbus. */
export const nymea: NamedFormat = {
  format: 'nymea',
  read: (value) => {
    if (!isObject(value) || !('className' in value) || !('endianness' in value)) return undefined;
    const enums = new Map(
      objectsIn(value['enums']).map((each) => [textOf(each['name']), namesText(each['values']) ?? '']),
    );
    const blocks = [{ id: '', registers: value['registers'] }, ...objectsIn(value['blocks'])];
    const rows = blocks.flatMap((block) =>
      objectsIn(valueAt(block, 'registers')).map((register) => rowOf(register, textOf(block['id']), enums)),
    );
    const addresses = new Map(rows.map(({ name, address }) => [name, address]));
    const table: NamedTable = {
      name: textOf(value['className']),
      facts: {
        counting: 'zero',
        order: textOf(value['endianness']) === 'LittleEndian' ? 'CDAB' : 'ABCD',
        device: textOf(value['className']),
      },
      rows: rows.map((row) => ({ ...row, scaleRegister: addresses.get(row.scaleRegister) ?? row.scaleRegister })),
    };
    return [table];
  },
};

function rowOf(register: Loose, group: string, enums: ReadonlyMap<string, string>): NamedRow {
  const exponent = numberOf(register['staticScaleFactor']);
  return {
    name: textOf(register['id']),
    address: textOf(register['address']),
    table: textOf(register['registerType']) || 'holdingRegister',
    type: textOf(register['type']),
    registers: textOf(register['size']),
    ...(exponent === undefined ? {} : { factor: 10 ** exponent }),
    scaleRegister: textOf(register['scaleFactor']),
    unit: textOf(register['unit']),
    access: textOf(register['access']),
    names: enums.get(textOf(register['enum'])),
    group,
    description: textOf(register['description']),
  };
}
