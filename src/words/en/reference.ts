import type { FunctionGroup, Table } from '../../modbus/index.ts';
import type { Gravity, ReferenceSubject } from '../../workbench/index.ts';
import { code, plural } from './common.ts';
import { misprints } from './misprints.ts';
import { openPoints } from './open-points.ts';
import { troublePlaces, troubles } from './troubles.ts';

const subjects: Readonly<Record<ReferenceSubject, string>> = {
  functions: 'Function codes',
  troubles: 'When it does not work',
  exceptions: 'Exception codes',
  subFunctions: 'Sub-functions of 08 Diagnostics',
  meiTypes: `MEI types of ${code(0x2b)}`,
  numbering: 'Entity numbers',
  units: 'Unit identifiers',
  sizes: 'Sizes of frames',
  limits: 'Limits of fields',
  ranges: 'All 256 codes',
  open: 'Left open by the specification',
  misprints: 'Misprints in the specifications',
};

const introductions: Readonly<Record<ReferenceSubject, string>> = {
  functions:
    'Fields in the order of their bytes, high byte first. The small number is the size in bytes; n is what a count or the end of the frame decides.',
  troubles: 'What is usual behind a sign, and where this page helps.',
  exceptions: 'The reply that refuses has two bytes: the function code plus 80, and one of these.',
  subFunctions:
    'What follows the sub-function in the request and in its reply. 05–09 and 16–FFFF are reserved, and so are those marked.',
  meiTypes: 'What follows the MEI type. All other types are reserved.',
  numbering:
    'A frame holds the table in its function code, and an address counted from 0. Manuals print one number for both: a digit for the table, and the address counted from 1.',
  units: 'Also called slave address, device address and station number.',
  sizes: 'The maximum, and what it is made of.',
  limits: 'What a field may hold, where that is less than fits into its bytes.',
  ranges: 'Who may use which function code, and who is known to use it.',
  open: 'Where devices differ, and both sides may be right.',
  misprints: 'Where a specification contradicts itself, or its own bytes.',
};

/** The first column heads the row. */
const columns: Readonly<Record<ReferenceSubject, readonly string[]>> = {
  functions: ['Code', 'Function', 'Table', 'Broadcast', 'Request and reply', 'Section'],
  troubles: ['Sign', 'What to look at', 'Here', 'Section'],
  exceptions: ['Code', 'Name', 'Means', 'Section'],
  subFunctions: ['Code', 'Name', 'Request and reply', 'Section'],
  meiTypes: ['Code', 'Name', 'Request and reply', 'Section'],
  numbering: ['Table', 'Holds', 'Five digits', 'Six digits', 'Functions', 'Section'],
  units: ['Unit', 'Line', 'Means', 'Section'],
  sizes: ['Frame', 'At most', 'Made of', 'Section'],
  limits: ['Function', 'Direction', 'Field', 'Legal', 'Hex', 'Section'],
  ranges: ['Code', 'Range', 'Known use', 'Section'],
  open: ['Question', 'What is known', 'Section'],
  misprints: ['Where', 'Printed', 'Right', 'What is wrong', 'Severity'],
};

/** What the rows of each table are found by besides what they show. */
const foundBy: Readonly<Record<ReferenceSubject, string>> = {
  functions: 'fc',
  troubles: 'trouble problem fault',
  exceptions: 'exception',
  subFunctions: 'sub-function diagnostics',
  meiTypes: 'mei',
  numbering: 'address number entity 0x 1x 3x 4x',
  units: 'unit slave address station',
  sizes: 'length maximum limit',
  limits: 'limit maximum fc',
  ranges: 'range',
  open: 'ambiguous open',
  misprints: 'misprint',
};

const access: Readonly<Record<Table, string>> = {
  coil: 'one bit, read and write',
  'discrete-input': 'one bit, read only',
  'input-register': 'two bytes, read only',
  'holding-register': 'two bytes, read and write',
  'file-record': 'two bytes, read and write',
};

/** Everything the reference says. */
export const reference = {
  groups: {
    bits: 'Bits',
    registers: 'Registers',
    files: 'Files',
    diagnostics: 'Diagnostics',
    identification: 'Identification',
    other: 'Other',
  } satisfies Record<FunctionGroup, string>,
  title: 'Modbus reference: functions, exceptions, limits, addresses. Framewright',
  search: 'Search the reference',
  searchHint: 'coil, 16, 0x10, 2Bh',
  tables: 'Tables',
  shown: (count: number, all: number) => (count === all ? plural(all, 'row') : `${count} of ${plural(all, 'row')}`),
  nothing: (text: string) => `Nothing here matches “${text}”.`,
  nothingHint:
    'Codes are found in decimal and hexadecimal: 43, 0x2B, 2Bh. Several words find the rows that have all of them.',
  clear: 'Show everything',
  subjects,
  introductions,
  foundBy,
  access,
  gravities: { wrong: 'Wrong', ambiguous: 'Ambiguous', note: 'Note' } satisfies Record<Gravity, string>,
  openPoints,
  troubles,
  troublePlaces,
  misprints,
  columns,
  request: 'Request',
  reply: 'Reply',
  of: (what: string, digits: string, name: string) => `${what} of ${digits} ${name}`,
  fieldIn: (field: string, functionCode: number, name: string, direction: string) =>
    `${field}, ${direction} of ${code(functionCode)} ${name}`,
  code,
  sameAsRequest: 'repeats the request',
  neverAnswered: 'none',
  goesOnBy: (field: string) => `then by ${field.replace(/^[A-Z](?![A-Z])/, (letter) => letter.toLowerCase())}`,
  nothingMore: 'nothing more',
  yes: 'yes',
  no: 'no',
  noTable: 'none',
  serialOnly: 'serial line only',
  reserved: 'reserved',
  bytes: (count: number) => plural(count, 'byte'),
  characters: (count: number) => plural(count, 'character'),
  sizes: {
    pdu: (pdu: number) => `function code 1, data 0 to ${pdu - 1}`,
    rtu: (pdu: number) => `unit 1, PDU up to ${pdu}, CRC 2`,
    ascii: (pdu: number) => `colon 1, two a byte for unit, PDU of up to ${pdu} and LRC, CR LF 2`,
    tcp: (pdu: number, header: number) => `MBAP header ${header}, PDU up to ${pdu}`,
  },
  serialLine: 'Serial line',
  tcp: 'TCP',
  unitOn: (line: string, units: string) => `${line}, unit ${units}`,
  unitMeanings: {
    broadcast: (functions: string) =>
      `Broadcast: every device listens, and no device answers. Agreed for functions ${functions}.`,
    single: 'One device each. The client has no address of its own.',
    reserved: 'Reserved: no device may have these.',
    direct: 'The TCP server itself: the value to send where there is no gateway.',
    tcpZero: 'The TCP server itself also; behind a gateway, a broadcast on its serial line.',
    behind: 'The device of this number on the serial line behind a gateway.',
    unspecified: 'Not specified. On a serial line these are reserved.',
  },
  fileNumbers: 'counted within each file, from 0',
  example: (address: string, number: string) => `address ${address} is ${number}`,
};
