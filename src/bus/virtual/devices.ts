import {
  addressesOf,
  builtInProfiles,
  type EntityTable,
  entityTables,
  isReadOnly,
  type Profile,
} from '../../devices/index.ts';
import type { CellRange } from './cells.ts';
import type { Device } from './device.ts';
import { type ServerParts, VirtualServer } from './server.ts';

/** What is not in a profile. */
type PartsBesides = Omit<ServerParts, 'name' | 'tables' | 'traits'>;

/** A device with the registers of a profile, all of them 0. */
export function serverFor(profile: Profile, parts: PartsBesides): VirtualServer {
  const rangesOf = (table: EntityTable): CellRange[] =>
    profile.registers
      .filter((register) => register.table === table)
      .map((register) => ({
        from: register.address,
        count: addressesOf(register, profile),
        writable: register.access !== 'r' && !isReadOnly(table),
      }));
  const tables = Object.fromEntries(entityTables.map((table) => [table, rangesOf(table)]));
  return new VirtualServer({ ...parts, name: profile.name, traits: profile.traits, tables });
}

const REFERENCE = 683;
const CONTROL = 682;
const SPEED = 681;
const DIRECTION = 685;
const RUN = 1;
const REVERSE = 1;
const FULL_SCALE = 8192;
/** From 0 to full speed, in milliseconds. */
const RAMP = 5000;
const WORD = 0xffff;

/** The speed of a drive follows its reference while bit 0 of the control word is set, and goes to 0 while it is not. */
function drive(): (device: Device, elapsed: number) => void {
  let speed = 0;
  return ({ tables }, elapsed) => {
    const cells = tables['holding-register'];
    const at = (address: number) => cells.read(address, 1)[0] ?? 0;
    const reference = Math.min(FULL_SCALE, at(REFERENCE));
    const runs = (at(CONTROL) & RUN) !== 0;
    const target = runs ? (at(DIRECTION) === REVERSE ? -reference : reference) : 0;
    const most = (FULL_SCALE * elapsed) / RAMP;
    speed += Math.max(-most, Math.min(most, target - speed));
    cells.write(SPEED, [Math.round(speed) & WORD]);
  };
}

/** The bits of these bytes, the lowest of the first byte first. */
const bitsOf = (...bytes: readonly number[]): number[] =>
  bytes.flatMap((byte) => Array.from({ length: 8 }, (_, bit) => (byte >> bit) & 1));

interface Model {
  /** Of the built-in profiles. */
  readonly profile: string;
  readonly parts: PartsBesides;
  /** Its first values. */
  readonly values: readonly (readonly [EntityTable, number, readonly number[]])[];
  /** Makes the behaviour of one such device. */
  readonly behaves?: () => (device: Device, elapsed: number) => void;
}

/**
 * The devices that the sources of the built-in profiles talk to, with the values of their examples. The I-8xx7 has unit 1
 * in some of them, as the S7-200 has; it stands at 9, as in its examples over TCP.
 */
const sources = {
  's7-200': {
    profile: 's7-200',
    parts: { unit: 1, functions: [1, 2, 3, 4, 5, 6, 15, 16] },
    values: [['holding-register', 0, [10, 20, 30, 40, 50]]],
  },
  'weg-drive': {
    profile: 'weg-drive',
    parts: { unit: 6, functions: [3, 6, 16, 43], objects: { 0: 'WEG', 1: 'CFW-11', 2: 'V1.0' } },
    values: [],
    behaves: drive,
  },
  'i-8xx7': {
    profile: 'i-8xx7',
    parts: { unit: 9, functions: [1, 2, 3, 4, 5, 6, 15, 16], overlap: true },
    values: [
      ['holding-register', 4, [8]],
      ['coil', 0x02, bitsOf(0x49)],
      ['coil', 0x1020, bitsOf(0x00, 0x12)],
    ],
  },
  'modicon-17': {
    profile: 'modicon-984',
    parts: {
      unit: 17,
      exceptionStatus: 0x6d,
      // A 984 that runs, as PI prints it for 17.
      serverId: '09FF04000020000000',
      files: { 4: [0, 0x0dfe, 0x0020, 0, 0, 0, 0, 0, 0, 0], 3: [0, 0, 0, 0, 0, 0, 0, 0, 0, 0x33cd, 0x0040] },
      fifos: { 1246: [0x01b8, 0x1284] },
      objects: { 0: 'Modicon', 1: '984', 2: 'V2.11' },
    },
    values: [
      ['coil', 0x13, bitsOf(0xcd, 0x6b, 0xb2, 0x0e, 0x1b)],
      ['discrete-input', 0xc4, bitsOf(0xac, 0xdb, 0x35)],
      ['holding-register', 0x6b, [555, 0, 100]],
      ['input-register', 0x08, [10]],
    ],
  },
  'modicon-33': {
    profile: 'modicon-984',
    parts: { unit: 33, functions: [1, 2, 3, 4, 5, 6, 15, 16] },
    values: [['holding-register', 999, [12345, 54321, 6666, 8888]]],
  },
} satisfies Readonly<Record<string, Model>>;

/** The devices that can be put on the virtual bus: those of the sources, and a plain one. */
export type ModelName = keyof typeof sources | 'plain';
const models: Readonly<Record<Exclude<ModelName, 'plain'>, Model>> = sources;
export const modelNames = [...(Object.keys(sources) as (keyof typeof sources)[]), 'plain'] as const;

/** Values that stand side by side in a table. */
export interface CellRun {
  readonly table: EntityTable;
  readonly from: number;
  readonly values: readonly number[];
}

/** A device of the virtual bus as plain data, for storage and messages. */
export interface DeviceSetup {
  /** Identifies the device, whatever its unit. */
  readonly id: number;
  readonly model: ModelName;
  /** Of a plain device: which registers it has, and what they are called. */
  readonly profile?: Profile | undefined;
  readonly unit: number;
  /** Whether it has power, and hears the line. */
  readonly on: boolean;
  /** Its values that are not 0; if absent, the first values of the model. */
  readonly values?: readonly CellRun[] | undefined;
  /** How the scales of the profile are meant; what was kept without a version has the old meaning. */
  readonly version?: 2 | undefined;
}

const PLAIN_ADDRESSES = 1000;

/** The profile of a device; a plain one may have none. */
export const profileOf = ({ model, profile }: Pick<DeviceSetup, 'model' | 'profile'>): Profile | undefined =>
  model === 'plain' ? profile : builtInProfiles.find(({ id }) => id === models[model].profile);

/** The device of a setup. */
export function serverOf({ model, profile, unit, values }: DeviceSetup): VirtualServer {
  const server = model === 'plain' ? plainServer(unit, profile) : modelServer(models[model], unit);
  const first = model === 'plain' || values !== undefined ? [] : models[model].values;
  for (const [table, from, list] of first) server.tables[table].write(from, list);
  for (const { table, from, values: list } of values ?? []) server.tables[table].write(from, list);
  return server;
}

function modelServer({ profile: id, parts, behaves }: Model, unit: number): VirtualServer {
  const profile = builtInProfiles.find((one) => one.id === id);
  if (profile === undefined) throw new RangeError(`no built-in profile ${id}`);
  return serverFor(profile, { ...parts, unit, ...(behaves && { behaviour: behaves() }) });
}

/** Without a profile, it has the same addresses in every table. */
function plainServer(unit: number, profile: Profile | undefined): VirtualServer {
  if (profile) return serverFor(profile, { unit });
  return new VirtualServer({
    name: 'plain',
    unit,
    tables: Object.fromEntries(
      entityTables.map((table) => [table, [{ from: 0, count: PLAIN_ADDRESSES, writable: !isReadOnly(table) }]]),
    ),
  });
}

/** The devices of the sources, each at its unit, in the order of the units. */
export const sourceSetups = (): DeviceSetup[] =>
  Object.entries(models).map(([model, { parts }], index) => ({
    id: index + 1,
    model: model as ModelName,
    unit: parts.unit,
    on: true,
  }));

/** The devices of the sources, new each time. */
export const sourceServers = (): VirtualServer[] => sourceSetups().map(serverOf);
