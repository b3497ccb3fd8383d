import { type Profile, plainRegister } from '../profile.ts';

const holding = { ...plainRegister, table: 'holding-register', count: 999 } as const;

export const enron: Profile = {
  id: 'enron-daniel',
  name: 'Enron, Daniel (flow computers)',
  source: 'The convention of Enron and Daniel flow computers, as vendors describe it',
  convention: 'zero-based',
  traits: ['one-address-each-value'],
  registers: [
    {
      ...plainRegister,
      name: 'Boolean {1001+1n}',
      table: 'coil',
      address: 1001,
      type: 'bits',
      count: 999,
      description: 'Boolean variables',
    },
    { ...holding, name: 'Short {3001+1n}', address: 3001, type: 'i16', description: '16-bit integers' },
    {
      ...holding,
      name: 'Long {5001+1n}',
      address: 5001,
      type: 'i32',
      description: '32-bit integers, counted one each, four bytes each',
    },
    {
      ...holding,
      name: 'Float {7001+1n}',
      address: 7001,
      type: 'f32',
      description: '32-bit floats, counted one each, four bytes each',
    },
  ],
  notes: [
    'In 5001 to 5999 and 7001 to 7999 each register has 32 bits and is counted as one: the quantity counts values, and a reply has four bytes for each. By the specification it is two (AP 6.3), so that a checking receiver calls the reply wrong.',
    'The register after 7001 is 7002, not 7003.',
    'The number is sent as it is: 7001 is 0x1B59. Some devices subtract 1 as elsewhere.',
    'High byte and high word first is usual; some devices swap the words.',
    'Writing one value of 32 bits takes 10 with quantity 1 and byte count 4; some take 06 with four bytes of value.',
    'Event and history archives (registers 32 and 701 on) have a layout of their own and are not in this table.',
  ],
};
