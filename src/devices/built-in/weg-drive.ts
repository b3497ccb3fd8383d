import { type Profile, plainRegister } from '../profile.ts';

const line = { ...plainRegister, table: 'holding-register' } as const;
/** 8192 is the full-scale frequency, here 60 Hz. */
const speed = { type: 'i16', factor: 60 / 8192, unit: 'Hz', decimals: 1 } as const;

export const wegDrive: Profile = {
  id: 'weg-drive',
  name: 'WEG drive',
  source: '“Modbus RTU for PLC Implementation, Complete Guide”: WEG drive, unit 6',
  convention: 'zero-based',
  serial: { baud: 9600, dataBits: 8, parity: 'none', stopBits: 1, unit: 6 },
  traits: [],
  registers: [
    {
      ...line,
      ...speed,
      name: 'P0681 actual speed',
      address: 681,
      access: 'r',
      description: '8192 is full scale, 60 Hz here. Below 0 in reverse.',
    },
    {
      ...line,
      name: 'P0682 control word',
      address: 682,
      type: 'bits',
      names: [
        { number: 0, name: 'run' },
        { number: 1, name: 'general enable' },
        { number: 2, name: 'direction' },
        { number: 3, name: 'jog' },
        { number: 4, name: 'remote' },
        { number: 5, name: 'second ramp' },
        { number: 6, name: 'quick stop' },
        { number: 7, name: 'fault reset' },
      ],
      description: 'Bit 0 runs and stops the motor. Set the speed first.',
    },
    {
      ...line,
      ...speed,
      name: 'P0683 speed reference',
      address: 683,
      description: '0 to 8192 for 0 to 100 %; 8192 is full scale, 60 Hz here.',
    },
    {
      ...line,
      name: 'P0685 direction',
      address: 685,
      names: [
        { number: 0, name: 'forward' },
        { number: 1, name: 'reverse' },
      ],
      description: 'As the guide has it.',
    },
  ],
  notes: [
    'The number of a parameter is sent as it is: P0683 is address 683 (0x02AB), which manuals that count from 1 call 40684.',
    'Full scale is not always 60 Hz. Where it is another, change the factor of P0681 and P0683: your frequency divided by 8192.',
    'The guide’s CRCs are wrong but for 01 03 00 00 00 0A C5 CD. Setting 30 Hz ends in F5 E5 (it prints E6 A1), run in 68 25 (F5 27), stop in A9 E5 (26 35), reading P0681 in 54 25 (D5 E7).',
    'The guide counts 11 bits a character, with parity, and says “usually none”. With 8N1 a character has 10 bits; 3.5 of them take 3.6 ms at 9600 baud.',
    'The guide names bit 0 of P0682 only. Bits 1 to 7 are named as in WEG’s manual of the CFW-11, where the motor needs bit 1, general enable, as well: 3 starts it, 1 alone does not.',
    'That manual has the direction in bit 2 of P0682. Check P0685 in the manual of your drive before writing to it.',
    'P0681 and P0683 are signed in that manual; the guide says 0 to 8192.',
  ],
};
