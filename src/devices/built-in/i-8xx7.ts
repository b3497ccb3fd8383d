import { type Profile, plainRegister } from '../profile.ts';

const COUNT = 0x4000;
const bits = { ...plainRegister, type: 'bits', address: 0, count: COUNT } as const;
const integers = { ...plainRegister, type: 'i16', address: 0, count: COUNT } as const;
const low = 'The low 16 bits of a 32-bit integer variable; the high ones cannot be read so.';

export const i8xx7: Profile = {
  id: 'i-8xx7',
  name: 'I-8xx7 controller',
  source: 'I-8xx7 manual, chapter 5: “Modbus protocol format”',
  convention: 'zero-based',
  traits: ['any-value-is-on', 'byte-count-plus-one'],
  registers: [
    {
      ...bits,
      name: 'Boolean {0000h+1n}',
      table: 'coil',
      description: 'Boolean variable by its network address. 01 reads, 05 and 0F write.',
    },
    {
      ...bits,
      name: 'Boolean {0000h+1n} by 02',
      table: 'discrete-input',
      access: 'r',
      description: 'The same variables: 02 reads what 01 reads.',
    },
    {
      ...integers,
      name: 'Integer {0000h+1n}',
      table: 'holding-register',
      description: `${low} 03 reads, 06 and 10 write.`,
    },
    {
      ...integers,
      name: 'Integer {0000h+1n} by 04',
      table: 'input-register',
      access: 'r',
      description: `${low} 04 reads what 03 reads.`,
    },
  ],
  notes: [
    'Network addresses are 0000 to 3FFF in hexadecimal and are sent as they are.',
    'An integer variable has 32 bits, and 03 answers only the low 16: 70000 is read as 4464.',
    '05 sets the variable with any first byte but 0. The specification allows FF 00 and 00 00 only (AP 6.5).',
    'The byte count of 0F is given as 1 + n/8. Where n is a multiple of 8 that is one more than the specification’s: 2 for 8 bits (AP 6.11). Whether the controller insists on it, the manual does not say.',
    'Its own reply over TCP to 8 bits read by 01 has byte count 1, so the formula holds for 0F alone.',
    'The high byte of every quantity is printed as 00, so that at most 255 elements are asked for.',
    'It calls the first byte of the CRC the high one. It is the low byte of the CRC register, as in the specification; the frames printed are right.',
  ],
};
