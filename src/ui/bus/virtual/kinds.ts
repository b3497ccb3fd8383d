import { type DeviceSetup, modelNames, profileOf } from '../../../bus/index.ts';
import { builtInProfiles } from '../../../devices/index.ts';
import { ownProfiles } from '../../device/chosen.ts';
import { virtualWords as words } from './language.ts';

/** What a device is called. */
export const nameOf = ({ model, profile }: Pick<DeviceSetup, 'model' | 'profile'>): string =>
  profile?.name ?? words.models[model];

/** What can be put on the line: the devices that the page knows, and one of each other profile. */
export function kindsOfDevice(): readonly Pick<DeviceSetup, 'model' | 'profile'>[] {
  const models = modelNames.map((model) => ({ model }));
  const known = new Set(models.map((one) => profileOf(one)?.id));
  const others = [...builtInProfiles.filter(({ id }) => !known.has(id)), ...ownProfiles()];
  return [...models, ...others.map((profile) => ({ model: 'plain' as const, profile }))];
}
