import { type Profile, plainRegister } from '../profile.ts';

export const s7200: Profile = {
  id: 's7-200',
  name: 'S7-200 with holding registers from VB800',
  source: '“Modbus RTU communication between PLC and PC”, an article on a Siemens S7-200 and C#',
  convention: 'five-digit',
  traits: [],
  registers: [
    {
      ...plainRegister,
      name: 'VW{800+2n}',
      table: 'holding-register',
      address: 0,
      count: 1000,
      description: 'Holding register n is VW(800 + 2(n − 1)): bytes VB800 and VB801 are register 1.',
    },
  ],
  notes: [
    'VB800 is what the article sets. In other programs the first register is elsewhere: change the 800 in the name of the line.',
    'The article does not say how many registers there are; 1000 is assumed here.',
    'V memory is addressed by bytes, so a register is two addresses further: register 3 is VW804, not VW802.',
    'The article gives 40000 to 49999 for holding registers. There is no 40000: they are 40001 to 49999, sent as 0 to 9998.',
    'The article puts values into C# “short”, which is signed: 40000 is shown as −25536.',
  ],
};
