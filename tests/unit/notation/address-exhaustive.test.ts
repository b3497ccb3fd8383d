import { describe, expect, it } from 'vitest';
import type { Table } from '../../../src/modbus/index.ts';
import {
  type AddressNotation,
  addressMeant,
  readAddress,
  writeAddress,
  zeroBasedAddress,
} from '../../../src/notation/index.ts';

const TABLES: readonly Table[] = ['coil', 'discrete-input', 'input-register', 'holding-register', 'file-record'];
/** The convention under which a notation is the first reading, where it is not understood by itself. */
const OWN = {
  decimal: 'protocol',
  hex: 'protocol',
  number: 'one-based',
  'five-digit': 'digits',
  'six-digit': 'digits',
  prefix: 'digits',
  letters: 'protocol',
  iec: 'protocol',
  'digit-from-zero': 'digit-from-zero',
} as const satisfies Record<Exclude<AddressNotation, 'plc'>, string>;

/** Nothing is written by the name that a controller has for it. */
const own = (notation: AddressNotation) => (notation === 'plc' ? 'protocol' : OWN[notation]);

/** Every address of the table that people write most, and so many of the others that each has all lengths and ends. */
const stepOf = (table: Table) => (table === 'holding-register' ? 1 : 5);

describe('every address, written in every notation, is read back', () => {
  it.each(TABLES)('%s', (table) => {
    const wrong: string[] = [];
    for (let address = 0; address <= 0xffff; address += stepOf(table)) {
      for (const { notation, text } of writeAddress(table, address)) {
        const first = addressMeant(text, own(notation), table);
        if (first?.address !== address || first.table !== table || first.notation !== notation)
          wrong.push(`${notation} ${text} of ${address}`);
        // The light reader, which the page's form has from the start, agrees where the full one reads a frame's field.
        if (own(notation) === 'protocol' && zeroBasedAddress(text) !== address) wrong.push(`zero-based ${text}`);
      }
    }
    expect(wrong.slice(0, 5)).toEqual([]);
  });

  it('has them among its meanings where no table and no convention is known', () => {
    const wrong: string[] = [];
    for (const table of TABLES) {
      for (const address of [0, 1, 107, 9997, 9998, 9999, 10000, 40000, 65534, 65535]) {
        for (const { notation, text } of writeAddress(table, address)) {
          const plain = notation === 'decimal' || notation === 'hex' || notation === 'number';
          const among = readAddress(text).some(
            (meaning) =>
              meaning.address === address &&
              meaning.notation === notation &&
              meaning.table === (plain ? undefined : table),
          );
          if (!among) wrong.push(`${notation} ${text} of ${table} ${address}`);
        }
      }
    }
    expect(wrong).toEqual([]);
  });
});
