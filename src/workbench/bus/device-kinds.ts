import { type DeviceSetup, type ModelName, modelNames, profileOf } from '../../bus/index.ts';
import { builtInProfiles, type Profile } from '../../devices/index.ts';

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
