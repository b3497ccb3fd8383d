import { isObject, type Loose, objectsIn, textOf } from '../loose.ts';
import { namesText } from '../object-names.ts';
import { type NamedFormat, type NamedRow, type NamedTable, readHolding, readInput } from './named-format.ts';

const TABLES = { read: readInput, hold: readHolding } as const;
/** A text of this file has ten registers. */
const TEXT_REGISTERS = 10;

/**
 * `registers-….yaml` of SunGather: https://github.com/bohdan-s/SunGather. Its addresses count from 1, and its values of 32 bits
 * have the low register first. `scan` says what is read at once, and names no registers.
 */
export const sungather: NamedFormat = {
  format: 'sungather',
  read: (value) => {
    const parts = objectsIn(isObject(value) ? value['registers'] : undefined);
    const tables = parts.flatMap((part) =>
      (['read', 'hold'] as const).flatMap((key): NamedTable[] => {
        const rows = objectsIn(part[key]).filter((row) => 'address' in row && 'datatype' in row);
        return rows.length === 0 ? [] : [{ name: key, facts: factsOf(value, TABLES[key]), rows: rows.map(rowOf) }];
      }),
    );
    return tables.length === 0 ? undefined : tables;
  },
};

const factsOf = (value: unknown, table: string) => ({
  table,
  counting: 'one',
  order: 'CDAB',
  ...(isObject(value) && textOf(value['vendor']) !== '' ? { device: textOf(value['vendor']) } : {}),
});

function rowOf(row: Loose): NamedRow {
  const type = textOf(row['datatype']);
  return {
    name: textOf(row['name']),
    address: textOf(row['address']),
    type,
    registers: /^utf/i.test(type) ? TEXT_REGISTERS : '',
    factor: textOf(row['accuracy']),
    unit: textOf(row['unit']),
    names: namesText(row['datarange']),
    mask: textOf(row['mask']),
    model: textOf(row['models']),
  };
}
