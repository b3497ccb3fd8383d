import type { Access, Convention, NamedValue, Register, SerialSettings, Trait } from '../../devices/index.ts';
import { isBitTable, isScaled, ratioText, scaleOf } from '../../devices/index.ts';
import { type Fraction, serialFormatName, type Table, toNumber } from '../../modbus/index.ts';
import { clearAddress } from '../../notation/index.ts';
import type { BadProfile, ProfileFile } from '../../workbench/index.ts';
import { addressIn, code, fields, plural, word } from './common.ts';
import { columns, deviceFault, deviceFile, faultAt } from './device-faults.ts';
import { numberText, valueText } from './register-numbers.ts';

const conventions: Readonly<Record<Convention, string>> = {
  'zero-based': 'addresses as they are sent, from 0',
  'one-based': 'numbers from 1',
  'five-digit': 'five digits, 40001',
  'six-digit': 'six digits, 400001',
};

const traits: Readonly<Record<Trait, string>> = {
  'one-address-each-value': 'A value of 32 bits is counted as one address and sent whole.',
  'any-value-is-on': '05 sets a coil with any first byte but 0.',
  'byte-count-plus-one': `The byte count of ${code(0x0f)} is 1 + n/8.`,
};

/** Said of a frame that breaks a rule as the device does. */
const departures: Readonly<Record<Trait, (device: string) => string>> = {
  'one-address-each-value': (device) =>
    `For ${device} it is right: there a value of 32 bits is counted as one, and has four bytes.`,
  'any-value-is-on': (device) => `For ${device} it is right: it takes any first byte but 00 as ON.`,
  'byte-count-plus-one': (device) => `For ${device} it is right: its byte count is 1 + n/8.`,
};

const accesses: Readonly<Record<Access, string>> = { r: 'read', w: 'write', rw: 'read, write' };

const serial = (settings: SerialSettings | undefined): string =>
  settings === undefined
    ? ''
    : `${settings.baud} ${serialFormatName(settings)}${settings.unit === undefined ? '' : `, unit ${settings.unit}`}`;

/** A factor or an offset: a quotient as it is, a number with few digits. */
function shortly(value: Fraction): string {
  const text = ratioText(value);
  return text.includes('/') ? text : String(Number(toNumber(value).toPrecision(7)));
}

/** `raw × 0.1 + 5`; empty if the value is the number itself. */
function scaleText(register: Register): string {
  if (!isScaled(register)) return '';
  const { factor, offset } = scaleOf(register);
  const isLess = offset.numerator < 0n;
  const plus = shortly(isLess ? { ...offset, numerator: -offset.numerator } : offset);
  const power = register.scaleRegister ? ` × 10^(register ${register.scaleRegister.address})` : '';
  const times = register.factor === 1 ? '' : ` × ${shortly(factor)}`;
  return `Value: raw${times}${power}${register.offset === 0 ? '' : ` ${isLess ? '−' : '+'} ${plus}`}`;
}

/** A value of a device: `P0681 actual speed = 4096 (30.0 Hz).` */
function named(value: NamedValue): string {
  const { register, name, raw, cutOff, scaled, names, exactly } = value;
  if (cutOff) return `${name} is cut off here.`;
  if (raw === undefined) return `${name} is not a value of ${register.type}.`;
  if (value.notImplemented) return `${name}: the device has no such value (${String(raw)}).`;
  if (typeof raw === 'string') return `${name} = “${raw}”.`;
  const also = names.length > 0 ? names.join(', ') : undefined;
  if (isBitTable(register.table)) return `${name} ${raw ? 'ON' : 'off'}${also ? ` (${also})` : ''}.`;
  const unit = register.unit ? ` ${register.unit}` : '';
  if (scaled === undefined)
    return `${name} = raw ${numberText(raw, { ...register, decimals: undefined })}; its power of ten is in register ${register.scaleRegister?.address}.`;
  if (scaled === raw) return `${name} = ${numberText(raw, register)}${unit}${also ? ` (${also})` : ''}.`;
  const inUnits = `${valueText(scaled, register, exactly)}${unit}`;
  return `${name} = ${String(raw).replace(/^-/, '−')} (${also ? `${inUnits}, ${also}` : inUnits}).`;
}

/** `30.0 Hz`, or what a value is called; empty if it is said by its number alone. */
function inUnits({ register, raw, scaled, names, exactly, notImplemented }: NamedValue): string {
  if (notImplemented) return 'not implemented';
  const unit = register.unit ? ` ${register.unit}` : '';
  const shown = typeof raw !== 'string' && scaled !== undefined && (scaled !== raw || unit !== '');
  return [...(shown ? [`${valueText(scaled, register, exactly)}${unit}`] : []), ...names].join(', ');
}

/** What the devices say. */
export const devices = {
  named,
  inUnits,
  nameOnly: (name: string) => `${name}.`,
  anyValueIsOn: 'This device takes any first byte but 0 as ON.',
  byteCountWanted: (count: number, quantity: number) =>
    `This device wants ${count}, which is 1 + ${quantity}/8: one more than the specification.`,
  useByteCount: (count: number) => `Give the frame this device’s byte count, ${count}`,
  conventions,
  traits,
  departures,
  accesses,
  columns,
  fault: deviceFault,
  faultAt,
  intro: 'Choose a device, and its registers are offered by name, and named in the frame.',
  profile: 'Device profile',
  none: 'None',
  builtIn: 'Built in',
  own: 'Your own',
  /** The group of a device that a link brought. */
  inLink: 'From the link',
  tooLarge:
    'This device has too many registers for a link: whoever opens the link gets the frame without names. Send its file too.',
  from: 'Source',
  manual: 'Its manual prints',
  serial,
  serialHint: 'Such as 9600 8N1, or 19200 8E1, unit 6. The unit is put into frames on a serial line.',
  serialWrong:
    'Write speed, data bits, parity (N, E, O) and stop bits, as 9600 8N1; then, if you like, “unit” and 0 to 255.',
  serialLine: 'Serial line',
  unit: 'Unit',
  lineTiming: 'Timing of this line',
  departs: 'Departs from the specification',
  odd: (count: number) => `Wrong or odd in its source: ${plural(count, 'point')}`,
  notes: 'Notes',
  notesHint: 'What is wrong or odd in its manual, one note a line.',
  search: 'Find a register',
  searchHint: 'A name, a word, an address in decimal or hex, or the number in the manual.',
  found: (count: number) => (count === 0 ? 'No register matches.' : plural(count, 'register')),
  table: 'Registers of this device',
  actions: 'Use',
  changes: 'Change',
  filters: { model: 'Model', group: 'Group', all: 'all' },
  order: 'In the order of',
  unsorted: 'the map',
  typeText: (register: Register) =>
    isBitTable(register.table)
      ? fields.tables[register.table].one
      : `${register.type}${register.order === 'ABCD' ? '' : ` ${register.order}`}, ${fields.tables[register.table].one}`,
  tableOf: (register: Register) => fields.tables[register.table].one,
  /** The number that the manual prints, and the address as sent, each on a line. */
  numberLines: (printed: string, address: number): readonly [string, string] =>
    printed === String(address) ? [`${address}`, word(address)] : [printed, `${address}, ${word(address)}`],
  numberColumn: 'Number, address',
  scaleText,
  /** What of a scale stands in no column. */
  scaleRest: ({ scaleRegister, offset }: Register, hasOffset: boolean) =>
    [scaleRegister ? '× 10^n' : '', hasOffset || offset === 0 ? '' : `${offset < 0 ? '−' : '+'} ${Math.abs(offset)}`]
      .filter((part) => part !== '')
      .join(' '),
  read: 'Read',
  write: 'Write',
  edit: 'Edit',
  remove: 'Remove',
  readOf: (name: string) => `Read ${name}`,
  writeOf: (name: string) => `Write ${name}`,
  editOf: (name: string) => `Edit ${name}`,
  removeOf: (name: string) => `Remove ${name}`,
  pick: (device: string) => `Register of ${device}`,
  pickFor: (device: string, field: string) => `Register of ${device}: ${field}`,
  pickNone: 'Choose a register',
  pickWith: (functionCode: number) => `With function ${code(functionCode)}`,
  pickMore: (count: number) => `${plural(count, 'register')} more: see the device below`,
  known: (typed: string, name: string, device: string) => `“${typed}” is ${name} in ${device}.`,
  useName: (place: string) => `Use ${place}`,
  chooseAndUse: (device: string, place: string) => `Choose ${device} and use ${place}`,
  placeText: (table: Table, address: number) => `${clearAddress(table, address)}, address ${addressIn(address)}`,
  partsOf: (count: number) => `The whole line takes ${plural(count, 'request')}`,
  part: (number: number, count: number, first: number, last: number) =>
    `${number} of ${count}: address ${first} to ${last}`,
  taken: (name: string, requests: number) =>
    requests > 1
      ? `The form above has the first of the ${requests} requests for ${name}. Choose the others there, below the address.`
      : `The form above has the request for ${name}.`,
  valueRead: 'Value read',
  connectFirst: 'To read registers here, connect first.',
  inForm: (name: string) => `The request for ${name} is the current frame.`,
  toForm: 'Open it in the Frame view',
  add: 'Add a register',
  /** The group of all fields of a register that have no column. */
  editTitle: (name: string) => `More of ${name}`,
  /** A cell that is edited. */
  cellOf: (column: string, name: string) => `${column} of ${name}`,
  editHint: 'Enter, F2 or a double click edits a cell; Enter and Tab keep it, Escape leaves it as it was.',
  newRegister: 'New register',
  added: (name: string) => `“${name}” is added.`,
  cellHints: {
    address: 'As sent, from 0; decimal or hex.',
    factor: 'The value is raw × factor + offset. 60/8192 is a number too.',
    count: 'Values that follow each other; of text, its registers.',
    decimals: 'Empty for as many as there are.',
    names: '0=stop; 1=run. Of type bits the bit, else the value.',
    scaleRegister: 'The address of the register with a power of ten, from 0.',
    notImplemented: 'The number that says “no value here”, such as 0x8000 or NaN.',
    mask: 'The bits of the number that are the value, such as 0xFF00.',
    models: 'Names with commas between them; empty for all.',
  } as Partial<Record<string, string>>,
  kept: (name: string) => `“${name}” is kept.`,
  removedRow: (name: string) => `“${name}” is removed.`,
  copied: (from: string, to: string) => `“${from}” is built in and stays as it is. Your change is in a copy, “${to}”.`,
  undoChange: 'Undo the last change',
  undone: 'The last change is undone.',
  redo: 'Redo',
  redone: 'The change is made again.',
  newProfile: 'New device',
  newName: 'My device',
  created: (name: string) => `“${name}” is created; it has no registers yet.`,
  rename: 'Name of this device',
  changed: (name: string) => `“${name}” is changed.`,
  delete: (name: string) => `Delete ${name}`,
  deleted: (name: string) => `“${name}” is deleted.`,
  undo: (name: string) => `Undo: bring ${name} back`,
  restored: (name: string) => `“${name}” is back.`,
  exports: {
    csv: 'Export as CSV',
    json: 'Export as JSON',
    'mbmap.json': 'Export as .mbmap.json',
    md: 'Export as Markdown',
  } satisfies Record<ProfileFile, string>,
  exported: (file: string) => `Written to ${file}.`,
  toLibrary: 'All devices, and the import of other makers’ maps',
  import: 'Import a register map',
  importFile: 'Import a file',
  paste: 'Or paste it here',
  importPasted: 'Import what is pasted',
  imported: (name: string, count: number) => `“${name}”: ${plural(count, 'register')} imported.`,
  nameTaken: (wanted: string, got: string) => `“${wanted}” is taken, and stays: this one is kept as “${got}”.`,
  already: (name: string) => `“${name}” is here already, unchanged.`,
  unreadable: (fault: Parameters<typeof deviceFile>[0]) =>
    `What an earlier page stored of your devices in this browser cannot be read. ${deviceFile(fault)} It is left as it is.`,
  badItems: (count: number) =>
    `${count === 1 ? 'One of your devices cannot be read, and is not shown. It stays' : `${count} of your devices cannot be read, and are not shown. They stay`} in the storage unchanged.`,
  badItem: ({ name, fault }: BadProfile) =>
    `${name === '' ? 'A device without a name' : `“${name}”`}: ${fault.code === 'not-profiles' ? 'this is not a device.' : 'line' in fault ? faultAt(fault, 'row') : deviceFile(fault)}`,
  fileName: 'framewright-devices.json',
  download: 'Download it',
  setAside: 'Set it aside',
  setAsideAs: (key: string) => `Set aside in the storage as “${key}”.`,
  refusals: {
    refused:
      'This browser allows this page no storage (a private window, or a setting). Your devices last until this page is closed. Export those that you want to keep.',
    full: 'The storage that this browser gives the page is full. What you changed last lasts until this page is closed. Export devices and delete some.',
    unreadable: 'Not stored: what this browser holds of your devices cannot be read, and is not saved over.',
    gone: 'Not stored: another tab deleted this device.',
  },
};
