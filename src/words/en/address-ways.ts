import { LAST_ADDRESS, type Table } from '../../modbus/index.ts';
import {
  type AddressConvention,
  type AddressNotation,
  type AddressRepair,
  type AddressTrap,
  type AddressTrapCode,
  type PlcCode,
  printedAddress,
} from '../../notation/index.ts';
import { addressIn, capital, code, elementIn, fields, plural } from './common.ts';

const notations: Readonly<Record<AddressNotation, string>> = {
  decimal: 'Address in the frame, from 0',
  hex: 'In hexadecimal',
  number: 'Number, from 1',
  'five-digit': 'Five digits',
  'six-digit': 'Six digits',
  prefix: 'With prefix',
  letters: 'With letters',
  iec: 'IEC 61131',
  'digit-from-zero': 'Digit, but from 0',
  plc: 'Name in a controller',
};

/** In which controllers a name has an address, and on what that depends. */
export const controllers: Readonly<Record<PlcCode, string>> = {
  directlogic: 'in a DirectLOGIC (its numbers are octal)',
  delta: 'in a Delta DVP',
  mitsubishi: 'in a Mitsubishi FX with its default mapping',
  wago: 'in a WAGO controller of the 750 series',
  twincat: 'in the Modbus server of TwinCAT (memory begins at 0x3000, bytes are counted)',
  'beckhoff-bc': 'in a Beckhoff BC or BX (flags begin at 0x4000, outputs at 0x0800, bytes are counted)',
  'siemens-db': 'in a Siemens controller whose data block is the Modbus area (bytes are counted)',
  'siemens-m': 'in a Siemens controller whose Modbus area begins with MW0 (bytes are counted)',
  rockwell: 'in a Rockwell controller whose Modbus area begins with this file',
  omron: 'in an Omron controller',
  schneider: 'in a Schneider controller, which counts words',
};

const conventions: Readonly<Record<AddressConvention, string>> = {
  protocol: 'Addresses from 0',
  'one-based': 'Numbers from 1',
  digits: 'Five or six digits',
  'digit-from-zero': 'A digit in front, from 0',
};

type Sentence<C extends AddressTrapCode> = (trap: Extract<AddressTrap, { code: C }>) => string;

const readSo = (text: string, got: number | undefined) =>
  got === undefined ? `“${text}” is not an address from 0.` : `“${text}” is read as address ${addressIn(got)}.`;

const first = (convention: AddressConvention, table: Table) => printedAddress(convention, table, 0)[0];

/** What each trap is. The buttons say what can be done about it. */
const traps: { readonly [C in AddressTrapCode]: Sentence<C> } = {
  'number-as-address': ({ text, got, table, address }) =>
    `${readSo(text, got)} As a number of five digits it is ${elementIn(table, address)}.`,
  'other-table': ({ text, named, table, functions }) =>
    `“${text}” is one of the ${fields.tables[named].many}. This function is for ${fields.tables[table].many}; for ${fields.tables[named].many} there ${functions.length === 1 ? 'is' : 'are'} ${functions.map(code).join(', ')}.`,
  'counted-from-one': ({ text, got, address }) =>
    `Address ${addressIn(got)} is number ${got + 1}. If the manual counts from 1, its ${text} is address ${addressIn(address)}.`,
  'counted-from-zero': ({ text, got, address }) =>
    `Read as a number from 1, which is address ${addressIn(got)}. If ${text} is an address from 0, it is ${addressIn(address)}.`,
  'digit-from-zero': ({ table, address }) =>
    `Some manuals put the digit of the table before addresses from 0, so that the first is ${first('digit-from-zero', table)}. Then this is address ${addressIn(address)}.`,
  'digit-from-one': ({ table, address }) =>
    `Most manuals put the digit of the table before numbers from 1, so that the first is ${first('digits', table)}. Then this is address ${addressIn(address)}.`,
  'past-five-digits': ({ text, got, table, address }) =>
    `${readSo(text, got)} Five digits end at number 9999. If they were counted on, ${text} is ${elementIn(table, address)}.`,
  'coil-or-hex': ({ text, got, address }) =>
    `${readSo(text, got)} 0x is the sign of hexadecimal and the old prefix of coils: it may also be address ${addressIn(address)}.`,
  'leading-zeros': ({ text, got, address }) =>
    address === undefined
      ? `${readSo(text, got)} Zeros in front change nothing here; in coils the first is the digit of the table.`
      : `${readSo(text, got)} With the digit of the coils in front it is ${elementIn('coil', address)}.`,
  'number-zero': ({ text, got, table }) =>
    `${readSo(text, got)} Numbers begin with 1, so no ${fields.tables[table].one} has it, unless the manual counts from 0.`,
  'over-end': ({ got, quantity }) =>
    `${plural(quantity, 'item')} from address ${addressIn(got)} go beyond the last address, ${addressIn(LAST_ADDRESS)}.`,
  'bit-of-register': ({ got, bit }) =>
    `Bit ${bit} of ${got === undefined ? 'the register' : `address ${addressIn(got)}`}: the function takes the whole register, bits 15 to 0.`,
  'grouped-digits': ({ text, got, address }) =>
    `${readSo(text, got)} If the point groups the digits, it is address ${addressIn(address)}.`,
  'plc-device': ({ text, got, plc, table, address }) =>
    `${got === undefined ? '' : `${readSo(text, got)} `}${capital(controllers[plc])}, ${text} is ${elementIn(table, address)}, address ${addressIn(address)}.`,
  'not-as-in-manual': ({ text, got, address }) =>
    `This field holds address ${addressIn(got)}, counted from 0. In your manual ${text} is address ${addressIn(address)}.`,
};

function trap(of: AddressTrap): string {
  // Each code has the sentence of its own trap.
  return (traps[of.code] as (of: AddressTrap) => string)(of);
}

function repair(of: AddressRepair): string {
  switch (of.kind) {
    case 'text':
      return `Use ${of.text}, address ${addressIn(of.address)}`;
    case 'function':
      return `Use function ${code(of.functionCode)} with ${of.text}`;
    case 'quantity':
      return `Ask for ${of.quantity}`;
  }
}

/** All ways to write an address, how manuals mean plain numbers, and what a typed one may be taken for by mistake. */
export const addressWays = {
  notations,
  conventions,
  trap,
  repair,
  notAnAddress: 'Correct the address to see all ways to write it.',
  element: (table: Table, address: number) => capital(elementIn(table, address)),
  nameIn: (device: string) => `In ${device}`,
  functions: (codes: readonly number[]) => `Functions that may use it: ${codes.map(code).join(', ')}.`,
  convention: 'Your manual’s convention',
  /** The self-check: what the first two of a table are called under a convention. */
  check: (table: Table, first: readonly string[], next: readonly string[]) =>
    `Then your manual’s first ${fields.tables[table].one} is printed as ${first.join(' or ')}, and the next as ${next.join(' or ')}. If not, choose another.`,
};
