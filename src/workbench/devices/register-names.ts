import { nameAt, type Profile, placesNamed } from '../../devices/index.ts';
import type { RegisterNames } from '../frame/device-names.ts';

/** The registers of a device by name. */
export const registerNamesOf = (profile: Profile): RegisterNames => ({
  device: profile.name,
  placeOf: (name, table) => {
    const places = placesNamed(profile, name);
    return places.find((place) => place.table === table) ?? places[0];
  },
  nameAt: (table, address) => (table === 'file-record' ? undefined : nameAt(profile, table, address)),
});
