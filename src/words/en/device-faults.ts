import {
  type Column,
  type DeviceFileFault,
  type LineFault,
  PROFILE_VERSION,
  type TableFault,
} from '../../devices/index.ts';
import { LAST_ADDRESS } from '../../modbus/index.ts';
import { addressIn, capital, fields } from './common.ts';

/** What the columns of a device's table are called. */
export const columns: Readonly<Record<Column, string>> = {
  name: 'Name',
  table: 'Table',
  address: 'Address',
  number: 'Number',
  type: 'Type',
  order: 'Byte order',
  count: 'Count',
  factor: 'Factor',
  offset: 'Offset',
  unit: 'Unit',
  decimals: 'Decimals',
  access: 'Access',
  names: 'Bits or values by name',
  description: 'Description',
  scaleRegister: 'Scale register',
  notImplemented: 'Not implemented',
  mask: 'Mask',
  group: 'Group',
  models: 'Models',
};

/** What is wrong with a line or a cell. */
export function deviceFault(fault: TableFault): string {
  switch (fault.code) {
    case 'cell-missing':
      return `${columns[fault.column]} is missing.`;
    case 'cell-unknown':
      return `${columns[fault.column]} “${fault.got}” is not known. Known are ${fault.known.join(', ')}.`;
    case 'cell-not-a-number':
      return `${columns[fault.column]} “${fault.got}” is not a number.`;
    case 'cell-out-of-range':
      return `${columns[fault.column]} ${fault.got} is not a whole number from ${fault.least} to ${fault.most}.`;
    case 'factor-zero':
      return 'The factor is 0: no value can be calculated from it.';
    case 'over-the-end':
      return `It would end at address ${fault.last}, and the last address is ${addressIn(LAST_ADDRESS)}.`;
    case 'number-of-other-table':
      return `Number ${fault.got} is one of the ${fields.tables[fault.table].many}, but the table says otherwise.`;
    case 'address-contradicts-number':
      return `Number ${fault.number} is address ${addressIn(fault.expected)}, but the address says ${addressIn(fault.got)}.`;
    case 'names-unreadable':
      return `“${fault.got}” does not say which bit or value has which name. Write 0=stop; 1=run.`;
    case 'type-not-for-table':
      return `${capital(fields.tables[fault.table].many)} are bits; type “${fault.got}” is for registers.`;
    case 'table-read-only':
      return `${capital(fields.tables[fault.table].many)} can only be read.`;
    case 'not-a-row':
      return 'It is not a register: name, table, address and so on.';
    case 'name-twice':
      return `“${fault.name}” is already at ${fault.first}; names must differ.`;
    case 'too-many-cells':
      return `It has ${fault.got} cells, and there are ${fault.most} columns. A comma inside a text needs quotes around the text.`;
    case 'quote-open':
      return 'A quote in it is not closed, or closed in the wrong place.';
    case 'header-missing':
      return 'The row of headers is missing. It names the columns; name, and address or number, must be among them.';
    case 'column-unknown':
      return `Column “${fault.got}” is not known and was left out.`;
    case 'column-twice':
      return `Column “${columns[fault.column]}” comes twice; the first was taken.`;
    case 'setting-unreadable':
      return `“${fault.setting}” cannot be read${fault.got ? `: ${fault.got}` : ''}. It was left out.`;
    case 'addresses-like-numbers':
      return 'All addresses of holding registers are from 40001 to 49999. If these are numbers as a manual prints them, call the column “number” and put a row “#convention,five-digit” above the headers.';
  }
}

/** A fault with its line, of a text, or its number in a list. */
export const faultAt = (fault: LineFault, where: 'line' | 'row'): string =>
  fault.line === 0 ? deviceFault(fault) : `${where === 'line' ? 'Line' : 'Row'} ${fault.line}: ${deviceFault(fault)}`;

/** Why a text is not a list of profiles. */
export function deviceFile(fault: DeviceFileFault): string {
  switch (fault.code) {
    case 'not-json':
      return `It is not JSON: ${fault.detail}`;
    case 'not-profiles':
      return 'It is JSON, but not a list of devices.';
    case 'too-deep':
      return `It has lists or objects inside each other, more than ${fault.most} deep.`;
    case 'newer-version':
      return `It has version ${fault.version}; this page knows versions up to ${PROFILE_VERSION}. A newer page can read it.`;
  }
}
