// What is right in public register maps: their rows, three of them, and the answers that only a person can give.
// `value` is what the raw number 490 stands for, with its unit.

const f32 = (table, address, unit) => ({ table, address, type: 'f32', factor: 1, unit });

export const known = [
  {
    file: /pysolarfocus/i,
    rows: 352,
    checked: [
      { table: 'input-register', address: 1100, type: 'i16', factor: 0.1, unit: '°C' },
      { table: 'input-register', address: 1353, type: 'u16', factor: 1, unit: '' },
      { table: 'input-register', address: 2316, type: 'i32', factor: 0.001, count: 1 },
    ],
  },
  {
    file: /SDM630\.csv$/i,
    rows: 85,
    checked: [f32('input-register', 0, 'V'), f32('input-register', 2, 'V'), f32('input-register', 8, 'A')],
  },
  {
    file: /Solis/i,
    rows: 662,
    checked: [12501, 12502, 12505].map((address) => ({ table: 'discrete-input', address })),
    never: ({ table, address }) => table === 'holding-register' && address >= 33000 && address < 34000,
  },
  {
    file: /attributes\.csv$/i,
    rows: 1003,
    checked: [
      { address: 2800, type: 'i32', factor: 1e-7, unit: 'Decimal degrees' },
      { address: 2804, type: 'u16', factor: 0.01, unit: 'Degrees' },
      { address: 2805, type: 'u16', factor: 0.01, unit: 'm/s' },
    ],
  },
  {
    file: /nymea.*sdm630/i,
    rows: 19,
    checked: [f32('input-register', 52, 'W'), f32('input-register', 0, 'V'), f32('input-register', 2, 'V')],
  },
  {
    file: /model_103/i,
    rows: 45,
    checked: [
      { address: 2, type: 'u16', unit: 'A', scaleRegister: 6 },
      { address: 10, type: 'u16', unit: 'V', scaleRegister: 13 },
      { address: 14, type: 'i16', unit: 'W', scaleRegister: 15 },
    ],
  },
  {
    file: /xtompok/i,
    rows: 65,
    answers: { table: 'input-register' },
    checked: [f32('input-register', 0, ''), f32('input-register', 2, ''), f32('input-register', 6, '')],
  },
  {
    file: /nibetcp/i,
    rows: 1379,
    checked: [1, 2, 3].map((address) => ({ table: 'input-register', address, type: 'i16', factor: 0.1, unit: '°C' })),
  },
];
