import { type Profile, plainRegister } from '../../../src/devices/index.ts';

/** A person's own device with one register. */
export const pump: Profile = {
  id: 'pump',
  name: 'Pump',
  source: 'manual',
  convention: 'zero-based',
  traits: [],
  registers: [{ ...plainRegister, name: 'Level', table: 'holding-register', address: 1 }],
  notes: [],
};
