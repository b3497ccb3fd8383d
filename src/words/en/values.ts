import { isBitTable, type NamedValue } from '../../devices/index.ts';
import {
  type BitEffect,
  type FormTypeName,
  formatFraction,
  isFormType,
  isNumberType,
  numberTypes,
  type Order,
  type ScaledReading,
  type ValueType,
  type ValueWriting,
} from '../../modbus/index.ts';
import {
  formatValue,
  formatValueHex,
  type InUnits,
  type Likely,
  type UnitLimits,
  type ValueFault,
  type ValueNote,
  type ValuesNotice,
} from '../../notation/index.ts';
import { code, plural } from './common.ts';
import { numberText, valueText } from './register-numbers.ts';

const typeNames: Readonly<Record<ValueType, string>> = {
  u16: 'UINT, WORD',
  i16: 'INT',
  f16: 'half float',
  bcd16: 'BCD, 4 digits',
  bits: 'bits 15 to 0',
  u32: 'UDINT, DWORD',
  i32: 'DINT',
  f32: 'REAL, float',
  bcd32: 'BCD, 8 digits',
  u64: 'ULINT',
  i64: 'LINT',
  f64: 'LREAL, double',
  text: 'UTF-8, ASCII',
  latin1: 'Latin-1',
  chars: 'a character a register',
  u8h: 'high byte',
  u8l: 'low byte',
  i8h: 'high byte, signed',
  i8l: 'low byte, signed',
  sm16: 'sign and magnitude',
  sbcd16: 'BCD, sign and 3 digits',
  bits32: 'bits 31 to 0',
  u24: 'low 24 bits',
  i24: 'low 24 bits, signed',
  sm32: 'sign and magnitude',
  sbcd32: 'BCD, sign and 7 digits',
  mod10k2: 'modulo 10,000',
  e8m24: 'decimal exponent, 24 bits',
  u48: '48 bits',
  i48: '48 bits, signed',
  mod10k3: 'modulo 10,000',
  bits64: 'bits 63 to 0',
  bcd64: 'BCD, 16 digits',
  mod10k4: 'modulo 10,000',
  timeiec: 'date, IEC 870-5-4',
  timeymd: 'date in byte pairs, year first',
  timemdy: 'date in byte pairs, month first',
  timebcd: 'date in BCD',
  timeunix: 'seconds since 1970',
  timeunix64: 'seconds since 1970',
  timeunixms: 'milliseconds since 1970',
  ip: 'IPv4 address',
  mac: 'MAC address',
  pf4q: '4-quadrant power factor',
};

/** How a value is typed that is not a number and not any text. */
const forms: Readonly<Record<FormTypeName, string>> = {
  timeiec: '2026-11-30 07:25:12',
  timeymd: '2026-11-30 07:25:12',
  timemdy: '2026-11-30 07:25:12',
  timebcd: '2026-11-30 07:25:12',
  timeunix: '2026-11-30 07:25:12',
  timeunix64: '2026-11-30 07:25:12',
  timeunixms: '2026-11-30 07:25:12.345',
  ip: '192.168.1.10',
  mac: '00:1A:2B:3C:4D:5E',
  pf4q: '0.95 lead',
};

const orderHints: Readonly<Record<Order, string>> = {
  ABCD: 'big endian',
  CDAB: 'word swap',
  BADC: 'byte swap',
  DCBA: 'little endian',
  CDABGHEF: 'word swap in pairs',
  EFGHABCD: 'pairs swapped',
  DCBAHGFE: 'byte and word swap in pairs',
  FEHGBADC: 'pairs and bytes swapped',
};

type Refusal = Exclude<ValueWriting, { kind: 'registers' }>;

function refusal(typed: string, type: ValueType, why: Refusal): string {
  switch (why.kind) {
    case 'out-of-range':
      return `${typed} does not fit into ${type}: ${why.least} to ${why.most}.`;
    case 'not-whole':
      return `${typed} is not a whole number, and ${type} holds nothing else. Use f32 or f64, or multiply by the scale first.`;
    case 'no-character':
      return `“${why.character}” is not a character of ${typeNames[type]}.`;
    case 'text-too-long':
      return `${plural(why.got, 'byte')} do not fit into ${why.most}.`;
    case 'no-such-form':
      return `“${typed}” is not a value of ${type}, or it has no place for it. Write it as "${isFormType(type) ? forms[type] : ''}".`;
  }
}

function fault(found: ValueFault): string {
  switch (found.code) {
    case 'value-missing':
      return 'A value is missing here.';
    case 'type-missing':
      return `“${found.typed}” has no type. Write one before it. If the comma is a decimal comma, write a point.`;
    case 'name-unknown':
      return `“${found.name}” is not a known name. A type comes first (u16, i32, f32, text), then an order (ABCD, CDAB, BADC, DCBA), then the value.`;
    case 'not-a-value':
      return `“${found.typed}” is not a value for ${found.type}.`;
    case 'hex-float':
      return `${found.typed} could be the bits of a float or a number. Write u32 for the bits, or the number in decimal.`;
    case 'quote-open':
      return 'A double quote is missing at the end of this text.';
    case 'text-unquoted':
      return `Put the text into double quotes: "${found.typed}".`;
    case 'refused':
      return refusal(found.typed, found.type, found.refusal);
    case 'unit-unknown':
      return found.known.length === 0
        ? `“${found.unit}” is not a unit of the register that it is written to. Choose a device that has it there, or set it under Scale.`
        : `“${found.unit}” is not a unit of the register that it is written to. Known there: ${found.known.join(', ')}.`;
    case 'outside-limits':
      return `${found.typed} is outside the limits: ${limits(found.limits)}.`;
    case 'outside-type':
      return `${found.typed} would be raw ${formatFraction(found.raw, 0)}, which does not fit into ${found.type}. It holds ${limits(found.limits)}.`;
  }
}

/** Digits shown behind those asked for, where a number is not exact. */
const MORE_DIGITS = 4;

function limits({ unit, least, most, decimals }: UnitLimits): string {
  const [low, high] = [least, most].map((end) => end && formatFraction(end, decimals));
  if (low === undefined) return `up to ${high} ${unit}`.trim();
  return `${high === undefined ? `from ${low}` : `${low} to ${high}`} ${unit}`.trim();
}

/** The number that stands for a value in units: `4096 (0x1000)`. */
function rawFor({ raw, type, exact, stands, unit, decimals }: InUnits): string {
  const number = `${formatValue(raw, type)} (${formatValueHex(raw, type)})`;
  return exact
    ? number
    : `${number}, rounded: it stands for ${formatFraction(stands, decimals + MORE_DIGITS)} ${unit}`.trim();
}

/** What a raw number stands for, and whether that is beyond the limits. */
function standsFor({ exactly, exact, outside }: ScaledReading, within: UnitLimits): string {
  const { unit, decimals } = within;
  const long = exact ? '' : `, more exactly ${formatFraction(exactly, decimals + MORE_DIGITS)}`;
  const stands = `stands for ${[formatFraction(exactly, decimals), unit].join(' ').trim()}${long}`;
  return outside ? `${stands}, outside the limits: ${limits(within)}` : stands;
}

const notANumber = 'Write a number: 21.5, -40, 1/3.';

function note(remark: ValueNote): string {
  switch (remark.code) {
    case 'precision-lost':
      return `${remark.typed} is rounded: the registers hold ${remark.stored}.`;
    case 'not-finite':
      return `${remark.typed} is not a finite number. Few devices expect it.`;
    case 'in-units':
      return `${remark.typed} is ${rawFor(remark.inUnits)}.`;
  }
}

function likely(reason: Likely): string {
  switch (reason.code) {
    case 'expected':
      return 'The value you expect.';
    case 'expected-rounded':
      return 'The value you expect, with more digits.';
    case 'expected-scaled':
      return `The value you expect, times ${10 ** reason.power}.`;
    case 'few-digits':
      return 'A float with few digits. Wrong orders have many.';
    case 'ordinary-size':
      return 'A float of ordinary size. By itself that says little.';
    case 'printable':
      return 'Text that can be read.';
    case 'small':
      return 'A small number: the upper half of its registers holds only the sign.';
  }
}

const effects: Readonly<Record<BitEffect, string>> = { keep: 'kept', set: 'set', clear: 'cleared' };

/** What a value of a device is, without its name and unit. */
function namedValue({ register, raw, scaled, names, cutOff, exactly, notImplemented }: NamedValue): string {
  const also = names.length > 0 ? names.join(', ') : undefined;
  const beside = also ? ` (${also})` : '';
  if (cutOff) return 'cut off';
  if (raw === undefined) return `not a value of ${register.type}`;
  if (notImplemented) return 'not implemented';
  if (typeof raw === 'string') return `“${raw}”`;
  if (isBitTable(register.table)) return `${raw ? 'ON' : 'off'}${beside}`;
  if (isNumberType(register.type) && numberTypes[register.type].kind === 'bits')
    return also ?? formatValueHex(raw, register.type);
  if (scaled === undefined) return `raw ${numberText(raw, { ...register, decimals: undefined })}, scale unknown`;
  return `${valueText(scaled, register, exactly)}${beside}`;
}

/** A number that may be read in another way; the buttons say as what. */
function otherReading({ code, typed, read }: ValuesNotice): string {
  const is = `${typed} is read as ${read}.`;
  return code === 'decimal-comma' ? `The comma is a decimal comma: ${is}` : `The point is a decimal point: ${is}`;
}

/** Values in registers. */
export const values = {
  typeNames,
  orderHints,
  fault,
  note,
  otherReading,
  readAs: (typed: string) => `Read it as ${typed}`,
  likely,
  effects,
  first: 'From register',
  register: (name: string, value: string) => `${name} = ${value}`,
  address: (address: number, number: string | undefined) =>
    number === undefined ? `address ${address}` : `${number}, address ${address}`,
  record: (file: number, record: number) => `file ${file}, record ${record}`,
  inList: (index: number) => `number ${index + 1} in the list`,
  expected: 'Expected value',
  expectedHint: 'A number or a text that should be there, such as 77.5.',
  marked: 'What it may be',
  noValues: 'This frame holds no registers and no bits.',
  /** The values that a device has names for. */
  named: 'By name',
  namedColumns: { name: 'name', value: 'value', unit: 'unit', raw: 'as sent' },
  namedValue,
  bitStates: 'Bits, the lowest address first',
  bitColumns: { address: 'addresses', states: 'bits', byte: 'byte' },
  /** A button that shows half floats and BCD too. */
  rare: 'Half floats and BCD',
  notMarked: 'Nothing here stands out. All readings are below.',
  notFound: 'The expected value is not in these registers, in any type or order.',
  elsewhere: 'Found elsewhere',
  goTo: (where: string) => `Go to ${where}`,
  width: (registers: number) => `${16 * registers} bits, ${plural(registers, 'register')}`,
  text: 'Text',
  order: 'order',
  hex: 'hex',
  none: '–',
  noDigits: 'no value of this type: a digit above 9, or no such date',
  typed: 'Typed values',
  typedHint:
    'Type, byte order and value, one a line: f32 CDAB 21.5, u16 4096, text "PUMP", 30 Hz. The order is ABCD if none is named.',
  line: (line: number) => `Line ${line}:`,
  registers: (count: number) => `${plural(count, 'register')}:`,
  apply: 'Put into the frame',
  namedBit: (bit: number, name: string) => `bit ${bit}: ${name}`,
  namedNumber: (number: number, name: string) => `${number} ${name}`,
  unnamed: (number: string) => `${number}, without a name`,
  notHere: (typed: string) => `It was typed as “${typed}”, with a device or a unit that is not chosen here.`,
  unitOpen: (typed: string) => `“${typed}”: choose a device, or say what full scale is.`,
  chooseDevice: 'Choose a device…',
  noDevice: (unit: string) => `No device here has values in ${unit}.`,
  sayFullScale: 'Full scale…',
  fullScale: (unit: string) => `Full scale, in ${unit}`,
  fullScaleRaw: 'is the number',
  fullScaleHint: (unit: string) => `As 60 Hz are 8192 in many drives. Values in ${unit} are then read in every field.`,
  takeFullScale: 'Use it',
  typeAgain: (outcome: string) => `${outcome} Type it again to put it into the frame.`,
  unitsKnown: (units: readonly string[]) => `Units known in these registers: ${units.join(', ')}.`,
  onlyOne: (got: number) =>
    `This function writes 1 register, and these values take ${got}. Choose function ${code(0x10)} for more.`,
  scale: 'Scale',
  scaleHint:
    'value = raw × factor + offset. Where 8192 stands for 60 Hz, the factor is 60/8192. With a unit set here, values such as 30 Hz can be typed wherever registers are written.',
  scaleLabels: {
    factor: 'Factor',
    offset: 'Offset',
    decimals: 'Decimals',
    unit: 'Unit',
    least: 'Minimum',
    most: 'Maximum',
    type: 'Type',
    order: 'Byte order',
  },
  scaleFaults: {
    factor: 'A factor is a number other than 0: 0.1, 10, 60/8192.',
    offset: notANumber,
    decimals: 'Digits behind the point, 0 to 12.',
    least: notANumber,
    most: notANumber,
    limits: 'The minimum is above the maximum.',
  },
  takeScale: (name: string) => `Take the scale of ${name}`,
  scaleTable: 'From minimum to maximum',
  doesNotFit: 'does not fit into the type',
  raw: 'Raw number',
  inUnits: 'Value in units',
  notANumber,
  notWhole: 'A raw number is whole: 4096, -5, 0x1000.',
  standsFor,
  rawFor,
  rawIs: (inUnits: InUnits) => `is raw ${rawFor(inUnits)}`,
  mask: 'Set and clear bits',
  maskIntro: `Function ${code(0x16)} changes single bits and keeps the others: (current AND and) OR (or AND NOT and).`,
  namedBits: 'Bits by name',
  doing: { keep: 'keep', set: 'set', clear: 'clear' } satisfies Readonly<Record<BitEffect, string>>,
  setBits: 'Set these bits',
  clearBits: 'Clear these bits',
  bitsHint: 'Numbers of bits, the lowest is 0: 0, 3, 8-11.',
  notABit: (text: string) => `“${text}” is not a bit of a register. Bits are 0 to 15: 0, 3, 8-11.`,
  bothWays: (bits: string) => `Bits set and cleared at once: ${bits}.`,
  current: 'A register that holds',
  notARegister: (text: string) =>
    `“${text}” is not a register value: whole numbers from 0 to 65535 (0x0000 to 0xFFFF).`,
  becomes: 'becomes',
  useMasks: 'Put the masks into the frame',
  andBit: 'AND bit',
  orBit: 'OR bit',
  from0: '0 gives',
  from1: '1 gives',
  effect: 'the bit is',
  bits: 'bits here',
  truth: 'Truth table',
  noBits: 'none',
};

export type ValueWords = typeof values;
