import { LAST_ADDRESS, type Table } from '../modbus/index.ts';

/** A family of controllers. */
export const plcCodes = [
  'directlogic',
  'delta',
  'mitsubishi',
  'wago',
  'twincat',
  'beckhoff-bc',
  'siemens-db',
  'siemens-m',
  'rockwell',
  'omron',
  'schneider',
] as const;
export type PlcCode = (typeof plcCodes)[number];

/** What a device name of a controller stands for, if the controller is of this family and mapped as its maker does. */
export interface PlcMeaning {
  readonly plc: PlcCode;
  readonly table: Table;
  /** Counted from 0. */
  readonly address: number;
}

/** Devices of a family: those from `from` on have addresses from `base` on. */
interface Row {
  readonly plc: PlcCode;
  /** What stands before the number. */
  readonly names: string;
  readonly table: Table;
  readonly base: number;
  /** The number is octal. */
  readonly octal?: true;
  readonly from?: number;
  /** How many of the number a register has: 2 where bytes are counted. */
  readonly each?: number;
}

const coil = 'coil';
const input = 'discrete-input';
const holding = 'holding-register';

/**
 * Devices as makers map them: DirectLOGIC (Modbus addressing of its manuals), Delta DVP, Mitsubishi FX with its default mapping, WAGO
 * (process image, flags from 0x3000), Beckhoff (TwinCAT Modbus server, and BC/BX with flags from 0x4000; both count bytes), data
 * blocks and memory of Siemens and files of Rockwell where the mapping begins with them, Omron, Schneider (`%MW100` without its sign).
 */
const ROWS: readonly Row[] = [
  { plc: 'directlogic', names: 'V', table: holding, base: 0, octal: true },
  { plc: 'directlogic', names: 'X', table: input, base: 2048, octal: true },
  { plc: 'directlogic', names: 'Y', table: coil, base: 2048, octal: true },
  { plc: 'directlogic', names: 'C', table: coil, base: 3072, octal: true },
  { plc: 'directlogic', names: 'S', table: coil, base: 5120, octal: true },
  { plc: 'directlogic', names: 'T', table: coil, base: 6144, octal: true },
  { plc: 'directlogic', names: 'CT', table: coil, base: 6400, octal: true },
  { plc: 'delta', names: 'S', table: coil, base: 0x0000 },
  { plc: 'delta', names: 'X', table: input, base: 0x0400, octal: true },
  { plc: 'delta', names: 'Y', table: coil, base: 0x0500, octal: true },
  { plc: 'delta', names: 'T', table: coil, base: 0x0600 },
  { plc: 'delta', names: 'M', table: coil, base: 0xb000, from: 1536 },
  { plc: 'delta', names: 'M', table: coil, base: 0x0800 },
  { plc: 'delta', names: 'C', table: coil, base: 0x0e00 },
  { plc: 'delta', names: 'D', table: holding, base: 0x9000, from: 4096 },
  { plc: 'delta', names: 'D', table: holding, base: 0x1000 },
  { plc: 'mitsubishi', names: 'D', table: holding, base: 0x1f40, from: 8000 },
  { plc: 'mitsubishi', names: 'D', table: holding, base: 0 },
  { plc: 'mitsubishi', names: 'M', table: coil, base: 0x1e00, from: 8000 },
  { plc: 'mitsubishi', names: 'M', table: coil, base: 0 },
  { plc: 'mitsubishi', names: 'S', table: coil, base: 0x2000 },
  { plc: 'mitsubishi', names: 'Y', table: coil, base: 0x3300, octal: true },
  { plc: 'mitsubishi', names: 'X', table: input, base: 0x3400, octal: true },
  { plc: 'wago', names: '%MW', table: holding, base: 0x3000 },
  { plc: 'wago', names: '%QW', table: holding, base: 0x0200 },
  { plc: 'twincat', names: '%MW', table: holding, base: 0x3000, each: 2 },
  { plc: 'beckhoff-bc', names: '%MW', table: holding, base: 0x4000, each: 2 },
  { plc: 'beckhoff-bc', names: '%QW', table: holding, base: 0x0800, each: 2 },
  { plc: 'siemens-db', names: 'DBW DBD', table: holding, base: 0, each: 2 },
  { plc: 'siemens-m', names: 'MW MD', table: holding, base: 0, each: 2 },
  { plc: 'rockwell', names: 'N7: F8: B3:', table: holding, base: 0 },
  { plc: 'omron', names: 'D DM', table: holding, base: 0 },
  { plc: 'schneider', names: 'MW', table: holding, base: 0 },
];

const NAME = /^(?:DB\d{1,5}\.)?(%?[A-Z]{1,3}(?:\d:)?)(\d{1,5})$/i;

/** What a text may be as the name of a device inside a controller, one for each family and mapping; at most a few. */
export function plcMeanings(text: string): readonly PlcMeaning[] {
  const [, name = '', digits = ''] = NAME.exec(text.trim()) ?? [];
  if (name === '') return [];
  const isBlock = /^DB\d/i.test(text.trim());
  const taken = new Set<string>();
  return ROWS.flatMap(({ plc, names, table, base, octal, from = 0, each = 1 }) => {
    if (!names.split(' ').includes(name.toUpperCase()) || isBlock !== (plc === 'siemens-db')) return [];
    if (octal && /[89]/.test(digits)) return [];
    const number = Number.parseInt(digits, octal ? 8 : 10);
    const address = base + (number - from) / each;
    if (
      number < from ||
      number > LAST_ADDRESS ||
      taken.has(plc) ||
      !Number.isInteger(address) ||
      address > LAST_ADDRESS
    )
      return [];
    taken.add(plc);
    return [{ plc, table, address }];
  });
}
