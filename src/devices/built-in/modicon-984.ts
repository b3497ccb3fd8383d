import { type EntityTable, type Profile, plainRegister, type Register } from '../profile.ts';

const FIVE = 9999;
const SIX = 65536;

function lines(table: EntityTable, digit: string, what: string): Register[] {
  const line: Register = {
    ...plainRegister,
    name: '',
    table,
    address: 0,
    type: table === 'coil' || table === 'discrete-input' ? 'bits' : 'u16',
    access: table === 'coil' || table === 'holding-register' ? 'rw' : 'r',
  };
  return [
    { ...line, name: `${digit}{0001+1n}`, count: FIVE, description: `${what}, five digits` },
    { ...line, name: `${digit}{00001+1n}`, count: SIX, description: `${what}, six digits` },
  ];
}

export const modicon984: Profile = {
  id: 'modicon-984',
  name: 'Modicon 984 references',
  source: 'A Chinese introduction to Modbus RTU, after the Modicon guide PI-MBUS-300',
  convention: 'five-digit',
  traits: [],
  registers: [
    ...lines('coil', '0', 'Coil'),
    ...lines('discrete-input', '1', 'Discrete input'),
    ...lines('input-register', '3', 'Input register'),
    ...lines('holding-register', '4', 'Holding register'),
  ],
  notes: [
    'A reference is the table’s digit and the address counted from 1: 40108 and 400108 are both address 107 (0x006B).',
    'The introduction gives 10000 elements to five digits. There are 9999: 0001 to 9999.',
    'The guide’s figure of a request for 40108 prints the address as 00 0B. It is 00 6B; 000B is 40012.',
    'The introduction works out 3.5 characters with 10 bits each, 3.645 ms at 9600 baud. RTU characters have 11 bits in the specification (SL 2.5.1): 4.01 ms.',
    'It lets stations be 0 to 255. 0 is the broadcast, 1 to 247 are devices, 248 to 255 are reserved (SL 2.2).',
    'Old controllers take less in one request: 100 registers by 10 and 800 coils by 0F on the 584 and 984 (PI App. B).',
  ],
};
