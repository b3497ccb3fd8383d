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
import { oneOf, record, someOf, whole } from '../stored.ts';

/** The settings of the scan. */
export interface ScanSettings {
  readonly what: ScanOrder['what'];
  readonly transport: SerialMode;
  readonly timeout: number;
  readonly firstUnit: number;
  readonly lastUnit: number;
  /** Tried in turn, each speed with each format; without any, the line stays as it is. */
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

export const scanSpeeds = [1200, 2400, 4800, 9600, 19_200, 38_400, 57_600, 115_200] as const;
const scanFormats = ['8E1', '8O1', '8N2', '8N1', '7E1', '7O1', '7N2'] as const;

/** The formats in which a frame of this mode has room. */
export const formatsFor = (mode: SerialMode): readonly string[] =>
  scanFormats.filter((name) => {
    const format = readSerialFormat(name);
    return format && formatStanding(mode, format) !== 'impossible';
  });

export const scannedTables = ['coil', 'discrete-input', 'holding-register', 'input-register'] as const;

/** The least and the most of each number. */
export const scanLimits = {
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
export type ScanNumber = keyof typeof scanLimits;

export const defaultScan: ScanSettings = {
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

export const scanTargets = ['units', 'functions', 'addresses'] as const;

/** Reads stored settings; those that are not legal become the default. */
export const readScanSettings = record<ScanSettings>(
  {
    what: oneOf(scanTargets),
    transport: oneOf(['rtu', 'ascii']),
    timeout: whole(...scanLimits.timeout),
    firstUnit: whole(...scanLimits.firstUnit),
    lastUnit: whole(...scanLimits.lastUnit),
    speeds: someOf<number>(scanSpeeds),
    formats: someOf<string>(scanFormats),
    unit: whole(...scanLimits.unit),
    table: oneOf(scannedTables),
    first: whole(...scanLimits.first),
    last: whole(...scanLimits.last),
    registers: whole(...scanLimits.registers),
    bits: whole(...scanLimits.bits),
    least: whole(...scanLimits.least),
  },
  defaultScan,
);

/** Which of the limits on a request holds for the table. */
export const scanMost = ({ table }: ScanSettings): 'bits' | 'registers' => (isBitTable(table) ? 'bits' : 'registers');

/** What is to be scanned; `current` is how the line is, or would be, open. `undefined` if the last comes before the first. */
export function scanOrder(settings: ScanSettings, current: LinkSettings): ScanOrder | undefined {
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
        : { ...common, what, unit, table, first, last, least, most: settings[scanMost(settings)] };
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
