import { type NamedNumber, type Profile, plainRegister, type Register } from '../profile.ts';

/** Where the map begins; some devices begin at 0 or 50000. */
const BASE = 40_000;
/** The inverter model stands behind the common model of 66 registers. */
const INVERTER = BASE + 70;

const line = { ...plainRegister, table: 'holding-register', access: 'r' } as const;

const counted = (names: readonly string[], first = 0): readonly NamedNumber[] =>
  names.map((name, index) => ({ number: first + index, name }));

const text = (address: number, name: string, count: number, description: string): Register => ({
  ...line,
  address,
  name,
  type: 'text',
  count,
  description,
});

/** A point of the inverter model, by its place in the model; `scale` is the place of its scale factor. */
const point = (
  place: number,
  name: string,
  type: 'u16' | 'i16' | 'u32',
  unit: string,
  scale: number,
  description: string,
): Register => ({
  ...line,
  address: INVERTER + place,
  name,
  type,
  unit,
  scaleRegister: { address: INVERTER + scale },
  notImplemented: { u16: '0xFFFF', i16: '0x8000', u32: '0' }[type],
  description,
});

const scaleFactor = (place: number, name: string): Register => ({
  ...line,
  address: INVERTER + place,
  name,
  type: 'i16',
  notImplemented: '0x8000',
  description: 'A power of ten.',
});

/** SunSpec's common model and its inverter models, which have the same registers for one, two and three phases. */
export const sunSpecInverter: Profile = {
  id: 'sunspec-inverter',
  name: 'SunSpec inverter (models 1 and 101 to 103)',
  source: 'SunSpec Alliance: models 1, 101, 102 and 103, as published',
  convention: 'zero-based',
  traits: [],
  registers: [
    text(BASE, 'SunS', 2, 'The mark at which a map of SunSpec is known: 53 75 6E 53.'),
    { ...line, address: BASE + 2, name: 'Common model: ID', description: '1.' },
    { ...line, address: BASE + 3, name: 'Common model: length', description: '65 or 66.' },
    text(BASE + 4, 'Mn', 16, 'Manufacturer.'),
    text(BASE + 20, 'Md', 16, 'Model.'),
    text(BASE + 36, 'Opt', 8, 'Options.'),
    text(BASE + 44, 'Vr', 8, 'Version.'),
    text(BASE + 52, 'SN', 16, 'Serial number.'),
    { ...line, address: BASE + 68, name: 'DA', access: 'rw', description: 'Unit identifier.' },
    {
      ...line,
      address: INVERTER,
      name: 'ID',
      names: [
        { number: 101, name: 'single phase' },
        { number: 102, name: 'split phase' },
        { number: 103, name: 'three phases' },
      ],
      description: 'The model.',
    },
    { ...line, address: INVERTER + 1, name: 'L', description: 'Length of the model: 50.' },
    point(2, 'A', 'u16', 'A', 6, 'AC current, sum of the phases.'),
    point(3, 'AphA', 'u16', 'A', 6, 'Current of phase A.'),
    point(4, 'AphB', 'u16', 'A', 6, 'Current of phase B.'),
    point(5, 'AphC', 'u16', 'A', 6, 'Current of phase C.'),
    scaleFactor(6, 'A_SF'),
    point(7, 'PPVphAB', 'u16', 'V', 13, 'Voltage between A and B.'),
    point(8, 'PPVphBC', 'u16', 'V', 13, 'Voltage between B and C.'),
    point(9, 'PPVphCA', 'u16', 'V', 13, 'Voltage between C and A.'),
    point(10, 'PhVphA', 'u16', 'V', 13, 'Voltage of phase A.'),
    point(11, 'PhVphB', 'u16', 'V', 13, 'Voltage of phase B.'),
    point(12, 'PhVphC', 'u16', 'V', 13, 'Voltage of phase C.'),
    scaleFactor(13, 'V_SF'),
    point(14, 'W', 'i16', 'W', 15, 'AC power.'),
    scaleFactor(15, 'W_SF'),
    point(16, 'Hz', 'u16', 'Hz', 17, 'Frequency.'),
    scaleFactor(17, 'Hz_SF'),
    point(18, 'VA', 'i16', 'VA', 19, 'Apparent power.'),
    scaleFactor(19, 'VA_SF'),
    point(20, 'VAr', 'i16', 'var', 21, 'Reactive power.'),
    scaleFactor(21, 'VAr_SF'),
    point(22, 'PF', 'i16', '%', 23, 'Power factor.'),
    scaleFactor(23, 'PF_SF'),
    point(24, 'WH', 'u32', 'Wh', 26, 'Energy since the beginning; it goes on from 0 after its end.'),
    scaleFactor(26, 'WH_SF'),
    point(27, 'DCA', 'u16', 'A', 28, 'DC current.'),
    scaleFactor(28, 'DCA_SF'),
    point(29, 'DCV', 'u16', 'V', 30, 'DC voltage.'),
    scaleFactor(30, 'DCV_SF'),
    point(31, 'DCW', 'i16', 'W', 32, 'DC power.'),
    scaleFactor(32, 'DCW_SF'),
    point(33, 'TmpCab', 'i16', '°C', 37, 'Temperature of the cabinet.'),
    point(34, 'TmpSnk', 'i16', '°C', 37, 'Temperature of the heat sink.'),
    point(35, 'TmpTrns', 'i16', '°C', 37, 'Temperature of the transformer.'),
    point(36, 'TmpOt', 'i16', '°C', 37, 'Another temperature.'),
    scaleFactor(37, 'Tmp_SF'),
    {
      ...line,
      address: INVERTER + 38,
      name: 'St',
      names: counted(['off', 'sleeping', 'starting', 'MPPT', 'throttled', 'shutting down', 'fault', 'standby'], 1),
      notImplemented: '0xFFFF',
      description: 'Operating state.',
    },
    {
      ...line,
      address: INVERTER + 39,
      name: 'StVnd',
      notImplemented: '0xFFFF',
      description: 'Operating state of the maker’s own.',
    },
    {
      ...line,
      address: INVERTER + 40,
      name: 'Evt1',
      type: 'bits32',
      names: counted([
        'ground fault',
        'DC over voltage',
        'AC disconnected',
        'DC disconnected',
        'grid disconnected',
        'cabinet open',
        'manual shutdown',
        'over temperature',
        'over frequency',
        'under frequency',
        'AC over voltage',
        'AC under voltage',
        'string fuse blown',
        'under temperature',
        'memory loss',
        'hardware test failed',
      ]),
      description: 'Events.',
    },
  ],
  notes: [
    'The map begins at 40000, 50000 or 0, where “SunS” stands. Manuals that count from 1 print 40001.',
    'The inverter model is found by going from model to model: its ID, then its length. Behind a common model of 65 registers, or behind other models, it begins elsewhere.',
    'Scale factors may change while the device runs: read them together with their values.',
    'Models 111 to 113 hold the same values as floats, at other addresses.',
  ],
};
