import {
  type CellRun,
  type DeviceSetup,
  type ModelName,
  modelNames,
  profileOf,
  type VirtualBusSettings,
} from '../../bus/index.ts';
import { builtInProfiles, entityTables, type Profile, readProfiles, writeProfiles } from '../../devices/index.ts';
import { LAST_ADDRESS, LAST_UNIT } from '../../modbus/index.ts';
import { type Decoder, flag, listOf, oneOf, whole } from '../stored.ts';

export type Pace = VirtualBusSettings['pace'];

/** How fast the virtual bus goes. */
export const readPace: Decoder<Pace> = oneOf(['line', 'fast']);

const WORD = 0xffff;
const id = whole(0, Number.MAX_SAFE_INTEGER);
const unit = whole(1, LAST_UNIT);
const model = oneOf(modelNames);
const table = oneOf(entityTables);
const address = whole(0, LAST_ADDRESS);
const cells = listOf(whole(0, WORD));

type Loose = Readonly<Record<string, unknown>>;
const loose = (stored: unknown): Loose | undefined =>
  typeof stored === 'object' && stored !== null ? (stored as Loose) : undefined;

const run: Decoder<CellRun> = (stored) => {
  const given = loose(stored);
  const [at, from, values] = [table(given?.['table']), address(given?.['from']), cells(given?.['values'])];
  if (at === undefined || from === undefined || values === undefined) return undefined;
  return from + values.length - 1 > LAST_ADDRESS ? undefined : { table: at, from, values };
};
const runs = listOf(run);

/** A profile, if its file would be read without a fault. */
const profile =
  (version: number): Decoder<Profile> =>
  (stored) => {
    const reading = readProfiles(writeProfiles([{ version, ...Object(stored) } as Profile]));
    const [one] = reading.kind === 'profiles' ? reading.profiles : [];
    return one?.faults.length === 0 ? one.profile : undefined;
  };

/** A part that may be absent: `wrong` if it is there and cannot be used. */
const part = <T>(stored: unknown, decode: Decoder<T>): T | 'wrong' | undefined =>
  stored === undefined ? undefined : (decode(stored) ?? 'wrong');

const setup: Decoder<DeviceSetup> = (stored) => {
  const given = loose(stored);
  if (given === undefined) return undefined;
  const own = {
    id: id(given['id']),
    model: model(given['model']),
    unit: unit(given['unit']),
    on: flag(given['on']),
  };
  const registers = part(given['profile'], profile(given['version'] === 2 ? 2 : 1));
  const values = part(given['values'], runs);
  if (own.id === undefined || own.model === undefined || own.unit === undefined || own.on === undefined)
    return undefined;
  if (registers === 'wrong' || values === 'wrong') return undefined;
  return {
    ...own,
    id: own.id,
    model: own.model,
    unit: own.unit,
    on: own.on,
    ...(registers && { profile: registers, version: 2 as const }),
    ...(values && { values }),
  };
};

/** The virtual devices out of a storage: those that can be used, and how many cannot. */
export interface ReadSetups {
  readonly devices: readonly DeviceSetup[];
  readonly bad: number;
}

/** `undefined` if what is stored is not a list. Of two devices with one number, the second cannot be told apart. */
export const readSetups: Decoder<ReadSetups> = (stored) => {
  if (!Array.isArray(stored)) return undefined;
  const devices = new Map<number, DeviceSetup>();
  for (const one of stored.flatMap((each) => setup(each) ?? [])) if (!devices.has(one.id)) devices.set(one.id, one);
  return { devices: [...devices.values()], bad: stored.length - devices.size };
};

/** The devices with the values that a session tells of them. */
export function withKeptValues(
  devices: readonly DeviceSetup[],
  told: readonly Pick<DeviceSetup, 'id' | 'values'>[],
): readonly DeviceSetup[] {
  const values = new Map(told.map((device) => [device.id, device.values]));
  return devices.map((device) => ({ ...device, values: values.get(device.id) ?? device.values }));
}

/** What kind of device a virtual one is. */
export type DeviceKind = Pick<DeviceSetup, 'model' | 'profile'>;

/** What a virtual device is called. */
export const kindName = ({ model, profile }: DeviceKind, models: Readonly<Record<ModelName, string>>): string =>
  profile?.name ?? models[model];

/** What can be put on the line: the devices that the page knows, and one of each other profile. */
export function deviceKinds(ownProfiles: readonly Profile[]): readonly DeviceKind[] {
  const models = modelNames.map((model) => ({ model }));
  const known = new Set(models.map((one) => profileOf(one)?.id));
  const others = [...builtInProfiles.filter(({ id }) => !known.has(id)), ...ownProfiles];
  return [...models, ...others.map((profile) => ({ model: 'plain' as const, profile }))];
}
