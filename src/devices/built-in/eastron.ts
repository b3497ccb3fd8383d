import { type Profile, plainRegister, type Register } from '../profile.ts';

type Row = readonly [address: number, name: string, unit: string];

/** A measured value: two input registers, a float, high word first. */
const measured = ([address, name, unit]: Row): Register => ({
  ...plainRegister,
  table: 'input-register',
  type: 'f32',
  access: 'r',
  address,
  name,
  unit,
});

/** A setting: two holding registers, a float too. */
const setting = (address: number, name: string, description: string, unit = ''): Register => ({
  ...plainRegister,
  table: 'holding-register',
  type: 'f32',
  address,
  name,
  unit,
  description,
});

/** A value of each of the three phases, two registers apart. */
const phases = (address: number, name: (phase: string) => string, unit: string, of = ['1', '2', '3']): readonly Row[] =>
  of.map((phase, index) => [address + 2 * index, name(phase), unit]);

const lines = ['1 to line 2', '2 to line 3', '3 to line 1'];

const parity = '0: no parity, one stop bit; 1: even, one; 2: odd, one; 3: none, two.';

const shared = [
  'All values are floats in two registers, the high word first, also settings that look like whole numbers. A request must not begin or end inside a value.',
  'Settings are written with function 16, two registers at once. Some need a key pressed at the meter before (“set” mode).',
] as const;

export const sdm630: Profile = {
  id: 'eastron-sdm630',
  name: 'Eastron SDM630',
  source: 'Eastron: SDM630 Modbus protocol, as the maker publishes it; compared with public register lists',
  convention: 'zero-based',
  serial: { baud: 9600, dataBits: 8, parity: 'none', stopBits: 1, unit: 1 },
  traits: [],
  registers: [
    ...(
      [
        ...phases(0, (phase) => `Phase ${phase} voltage`, 'V'),
        ...phases(6, (phase) => `Phase ${phase} current`, 'A'),
        ...phases(12, (phase) => `Phase ${phase} active power`, 'W'),
        ...phases(18, (phase) => `Phase ${phase} apparent power`, 'VA'),
        ...phases(24, (phase) => `Phase ${phase} reactive power`, 'var'),
        ...phases(30, (phase) => `Phase ${phase} power factor`, ''),
        ...phases(36, (phase) => `Phase ${phase} phase angle`, '°'),
        [42, 'Average line to neutral voltage', 'V'],
        [46, 'Average line current', 'A'],
        [48, 'Sum of line currents', 'A'],
        [52, 'Total active power', 'W'],
        [56, 'Total apparent power', 'VA'],
        [60, 'Total reactive power', 'var'],
        [62, 'Total power factor', ''],
        [66, 'Total phase angle', '°'],
        [70, 'Frequency', 'Hz'],
        [72, 'Imported active energy', 'kWh'],
        [74, 'Exported active energy', 'kWh'],
        [76, 'Imported reactive energy', 'kvarh'],
        [78, 'Exported reactive energy', 'kvarh'],
        [80, 'Apparent energy', 'kVAh'],
        [82, 'Charge', 'Ah'],
        [84, 'Active power demand', 'W'],
        [86, 'Maximum active power demand', 'W'],
        [100, 'Apparent power demand', 'VA'],
        [102, 'Maximum apparent power demand', 'VA'],
        [104, 'Neutral current demand', 'A'],
        [106, 'Maximum neutral current demand', 'A'],
        ...phases(200, (pair) => `Line ${pair} voltage`, 'V', lines),
        [206, 'Average line to line voltage', 'V'],
        [224, 'Neutral current', 'A'],
        ...phases(234, (phase) => `Phase ${phase} voltage THD`, '%'),
        ...phases(240, (phase) => `Phase ${phase} current THD`, '%'),
        [248, 'Average line to neutral voltage THD', '%'],
        [250, 'Average line current THD', '%'],
        ...phases(258, (phase) => `Phase ${phase} current demand`, 'A'),
        ...phases(264, (phase) => `Maximum phase ${phase} current demand`, 'A'),
        ...phases(334, (pair) => `Line ${pair} voltage THD`, '%', lines),
        [340, 'Average line to line voltage THD', '%'],
        [342, 'Total active energy', 'kWh'],
        [344, 'Total reactive energy', 'kvarh'],
        ...phases(346, (phase) => `Phase ${phase} imported active energy`, 'kWh'),
        ...phases(352, (phase) => `Phase ${phase} exported active energy`, 'kWh'),
        ...phases(358, (phase) => `Phase ${phase} total active energy`, 'kWh'),
        ...phases(364, (phase) => `Phase ${phase} imported reactive energy`, 'kvarh'),
        ...phases(370, (phase) => `Phase ${phase} exported reactive energy`, 'kvarh'),
        ...phases(376, (phase) => `Phase ${phase} total reactive energy`, 'kvarh'),
      ] as const
    ).map(measured),
    setting(2, 'Demand period', '0, 5, 8, 10, 15, 20, 30 or 60.', 'min'),
    setting(10, 'System type', '1: single phase; 2: three phases, three wires; 3: three phases, four wires.'),
    setting(12, 'Pulse width', '60, 100 or 200.', 'ms'),
    setting(18, 'Parity and stop bits', parity),
    setting(20, 'Unit identifier', '1 to 247.'),
    setting(28, 'Speed', '0: 2400 baud; 1: 4800; 2: 9600; 3: 19200; 4: 38400.'),
  ],
  notes: [
    ...shared,
    'Editions of the protocol differ in the higher registers: some lists have them for the SDM630MCT only. Compare one value with the meter’s display.',
    'Manuals print 30001 for address 0. The maker calls the units of reactive power and energy VAr and kVArh.',
  ],
};

export const sdm120: Profile = {
  id: 'eastron-sdm120',
  name: 'Eastron SDM120',
  source: 'Eastron: SDM120 Modbus protocol, as the maker publishes it; compared with public register lists',
  convention: 'zero-based',
  serial: { baud: 2400, dataBits: 8, parity: 'none', stopBits: 1, unit: 1 },
  traits: [],
  registers: [
    ...(
      [
        [0, 'Voltage', 'V'],
        [6, 'Current', 'A'],
        [12, 'Active power', 'W'],
        [18, 'Apparent power', 'VA'],
        [24, 'Reactive power', 'var'],
        [30, 'Power factor', ''],
        [70, 'Frequency', 'Hz'],
        [72, 'Imported active energy', 'kWh'],
        [74, 'Exported active energy', 'kWh'],
        [76, 'Imported reactive energy', 'kvarh'],
        [78, 'Exported reactive energy', 'kvarh'],
        [84, 'Active power demand', 'W'],
        [86, 'Maximum active power demand', 'W'],
        [88, 'Imported active power demand', 'W'],
        [90, 'Maximum imported active power demand', 'W'],
        [92, 'Exported active power demand', 'W'],
        [94, 'Maximum exported active power demand', 'W'],
        [258, 'Current demand', 'A'],
        [264, 'Maximum current demand', 'A'],
        [342, 'Total active energy', 'kWh'],
        [344, 'Total reactive energy', 'kvarh'],
      ] as const
    ).map(measured),
    setting(12, 'Pulse width', '60, 100 or 200.', 'ms'),
    setting(18, 'Parity and stop bits', parity),
    setting(20, 'Unit identifier', '1 to 247.'),
    setting(28, 'Speed', '0: 2400 baud; 1: 4800; 2: 9600; 5: 1200.'),
  ],
  notes: [
    ...shared,
    'New meters have 2400 baud, where most others of the maker have 9600.',
    'Manuals print 30001 for address 0.',
  ],
};
