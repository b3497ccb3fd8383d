import type { LinkSettings, ScanOrder } from '../../bus/index.ts';
import { type EntityTable, isBitTable, mostRead } from '../../devices/index.ts';
import {
  FIRST_UNIT,
  formatStanding,
  LAST_ADDRESS,
  LAST_UNIT,
  readSerialFormat,
  type SerialMode,
} from '../../modbus/index.ts';
import { Remembered } from '../tools/remembered.ts';

/** How is scanned, as chosen last. */
export interface ScanSettings {
  readonly what: ScanOrder['what'];
  readonly transport: SerialMode;
  readonly timeout: number;
  readonly firstUnit: number;
  readonly lastUnit: number;
  /** Tried in turn, each speed with each format; none is that of the line. */
  readonly speeds: readonly number[];
  readonly formats: readonly string[];
  readonly unit: number;
  readonly table: EntityTable;
  readonly first: number;
  readonly last: number;
  readonly registers: number;
  readonly bits: number;
  readonly least: number;
}

export const speeds = [1200, 2400, 4800, 9600, 19_200, 38_400, 57_600, 115_200] as const;
const formats = ['8E1', '8O1', '8N2', '8N1', '7E1', '7O1', '7N2'] as const;

/** Those in which a frame has room. */
export const formatsFor = (mode: SerialMode): readonly string[] =>
  formats.filter((name) => {
    const format = readSerialFormat(name);
    return format && formatStanding(mode, format) !== 'impossible';
  });

export const tables = ['coil', 'discrete-input', 'holding-register', 'input-register'] as const;

/** The least and the most of each number. */
export const limits = {
  timeout: [1, 60_000],
  firstUnit: [FIRST_UNIT, LAST_UNIT],
  lastUnit: [FIRST_UNIT, LAST_UNIT],
  unit: [FIRST_UNIT, LAST_UNIT],
  first: [0, LAST_ADDRESS],
  last: [0, LAST_ADDRESS],
  registers: [1, mostRead.registers],
  bits: [1, mostRead.bits],
  least: [1, mostRead.bits],
} as const;
export type NumberName = keyof typeof limits;

const usual: ScanSettings = {
  what: 'units',
  transport: 'rtu',
  timeout: 100,
  firstUnit: FIRST_UNIT,
  lastUnit: LAST_UNIT,
  speeds: [],
  formats: [],
  unit: 1,
  table: 'holding-register',
  first: 0,
  last: 999,
  registers: mostRead.registers,
  bits: mostRead.bits,
  least: 1,
};

/** What is stored, as far as it can be used. */
function readSettings(value: unknown): ScanSettings {
  const stored = (value ?? {}) as Partial<Record<keyof ScanSettings, unknown>>;
  const number = (name: NumberName) => {
    const [least, most] = limits[name];
    const one = stored[name];
    return typeof one === 'number' && Number.isInteger(one) && one >= least && one <= most ? one : usual[name];
  };
  const one = <T>(of: readonly T[], name: 'what' | 'transport' | 'table', otherwise: T) =>
    of.find((each) => each === stored[name]) ?? otherwise;
  const some = <T>(of: readonly T[], name: 'speeds' | 'formats') => {
    const chosen = stored[name];
    return Array.isArray(chosen) ? of.filter((each) => chosen.includes(each)) : [];
  };
  return {
    what: one<ScanSettings['what']>(['units', 'functions', 'addresses'], 'what', usual.what),
    transport: one<SerialMode>(['rtu', 'ascii'], 'transport', usual.transport),
    timeout: number('timeout'),
    firstUnit: number('firstUnit'),
    lastUnit: number('lastUnit'),
    speeds: some<number>(speeds, 'speeds'),
    formats: some<string>(formats, 'formats'),
    unit: number('unit'),
    table: one<EntityTable>(tables, 'table', usual.table),
    first: number('first'),
    last: number('last'),
    registers: number('registers'),
    bits: number('bits'),
    least: number('least'),
  };
}

export const scanSettings = new Remembered<ScanSettings>('scan', usual, readSettings);

/** Which of the limits on a request holds for the table. */
export const mostName = ({ table }: ScanSettings): 'bits' | 'registers' => (isBitTable(table) ? 'bits' : 'registers');

/** What is to be scanned; `current` is how the line is, or would be, open. `undefined` where the last is before the first. */
export function orderOf(settings: ScanSettings, current: LinkSettings): ScanOrder | undefined {
  const { what, transport, timeout, unit } = settings;
  const common = { kind: 'scan', transport, timeout } as const;
  switch (what) {
    case 'units': {
      const { firstUnit: first, lastUnit: last } = settings;
      return first > last ? undefined : { ...common, what, first, last, lines: linesOf(settings, current) };
    }
    case 'functions':
      return { ...common, what, unit };
    case 'addresses': {
      const { table, first, last, least } = settings;
      return first > last
        ? undefined
        : { ...common, what, unit, table, first, last, least, most: settings[mostName(settings)] };
    }
  }
}

/** Each speed with each format. */
function linesOf({ speeds, transport, ...settings }: ScanSettings, current: LinkSettings): readonly LinkSettings[] {
  const names = formatsFor(transport).filter((name) => settings.formats.includes(name));
  if (speeds.length === 0 && names.length === 0) return [];
  const tried = names.length > 0 ? names.flatMap((name) => readSerialFormat(name) ?? []) : [current];
  const bauds = speeds.length > 0 ? speeds : [current.baud];
  return bauds.flatMap((baud) =>
    tried.map(({ dataBits, parity, stopBits }) => ({ ...current, baud, dataBits, parity, stopBits })),
  );
}
