import { describe, expect, it, test } from 'vitest';
import { addressTraps, readAddress, zeroBasedAddress } from '../../../src/notation/index.ts';

const reads = { functionCode: 0x03, table: 'holding-register' } as const;
const first = (text: string, convention: 'digits' | 'protocol' = 'digits') =>
  readAddress(text, convention, 'holding-register')[0];
const holding = (address: number, more: object = {}) => ({ table: 'holding-register', address, ...more });

describe('an address in what people write around it', () => {
  it.each([
    ['40001.5', holding(0, { bit: 5 })],
    ['40001.0', holding(0, { bit: 0 })],
    ['40001.15', holding(0, { bit: 15 })],
    ['40001:5', holding(0, { bit: 5 })],
    ['40001/5', holding(0, { bit: 5 })],
    ['40108 bit 3', holding(107, { bit: 3 })],
    ['400108.12', holding(107, { bit: 12 })],
    ['HR108.3', holding(107, { bit: 3 })],
    ['0x006B.3', holding(107, { bit: 3 })],
    ['%MW100:X3', holding(100, { bit: 3 })],
    ['%MW100.3', holding(100, { bit: 3 })],
    ['40001-40002', holding(0, { quantity: 2 })],
    ['40001..40010', holding(0, { quantity: 10 })],
    ['40001–40002', holding(0, { quantity: 2 })],
    ['40001-02', holding(0, { quantity: 2 })],
    ['0x1000-0x1003', holding(4096, { quantity: 4 })],
    ['412380.10L', holding(12379, { quantity: 5, lowByteFirst: true })],
    ['400001.7H', holding(0, { quantity: 4 })],
    ['0x1000 (4096)', holding(4096)],
    ['4096 (0x1000)', holding(4096)],
    ['0x1000/4096', holding(4096)],
    ['40001 (0)', holding(0)],
    ['0 (40001)', holding(0)],
    ['0x0000 / 40001', holding(0)],
    ['40001[5]', holding(0, { bit: 5 })],
    ['40001.b5', holding(0, { bit: 5 })],
    ['40001.A', holding(0, { bit: 10 })],
    ['Register 40001', holding(0)],
    ['reg. 40001', holding(0)],
    ['H1000', holding(4096)],
    ['&H1000', holding(4096)],
    ['h0BB7', holding(0x0bb7)],
    ['4-0001', holding(0)],
    ['4 0001', holding(0)],
    ['4-00108', holding(107)],
    ['40 001', holding(0)],
    ['40,001', holding(0)],
    ['40.001', holding(0)],
    ['400 001', holding(0)],
  ])('%s', (text, expected) => {
    expect(first(text)).toMatchObject(expected);
  });

  it.each(['40001.16', '40001.5.3', '0x1000 (4097)', '40002-40001', 'H10000G', '4-01', '1.5.2'])(
    '%s is none',
    (text) => {
      expect(readAddress(text, 'digits', 'holding-register')).toEqual([]);
    },
  );

  test('a frame’s own field takes it, too, as an address from 0; what it took before is as before', () => {
    const taken = ['0x1000 (4096)', 'H1000', '4-0108', 'HR108.3', '%MW100:X3', '40001.5', '40 001'];
    expect(taken.map(zeroBasedAddress)).toEqual([4096, 4096, 107, 107, 100, 40001, 40001]);
    expect(['1.5', '107', '0x6B', 'HR108', '%QX13.3'].map(zeroBasedAddress)).toEqual([1.5, 107, 107, 107, 107]);
    // A slash and a dash stand between address and quantity, or between two addresses.
    expect(['40108/3', '17/40108', '40001-40002', 'V2000'].map(zeroBasedAddress)).toEqual(new Array(4).fill(undefined));
  });

  it('has the bit said, and digits that may be grouped', () => {
    expect(addressTraps('0x006B.3', reads)).toMatchObject([
      { code: 'bit-of-register', severity: 'note', got: 107, bit: 3 },
    ]);
    expect(addressTraps('1.000', reads)).toContainEqual(
      expect.objectContaining({ code: 'grouped-digits', severity: 'warning', got: 1, address: 1000 }),
    );
  });
});

describe('the name of a device inside a controller', () => {
  it.each([
    // DirectLOGIC: V-memory is octal, and V2000 is address 1024; Y0 is coil 2048 and X0 input 2048.
    ['V2000', 'directlogic', 'holding-register', 1024],
    ['Y0', 'directlogic', 'coil', 2048],
    ['C10', 'directlogic', 'coil', 3080],
    ['CT1', 'directlogic', 'coil', 6401],
    // Delta DVP: D0 is 0x1000 and D4096 0x9000; Y0 is 0x0500 and Y10, octal, 0x0508; M1536 is 0xB000.
    ['D100', 'delta', 'holding-register', 0x1064],
    ['D4096', 'delta', 'holding-register', 0x9000],
    ['Y10', 'delta', 'coil', 0x0508],
    ['X0', 'delta', 'discrete-input', 0x0400],
    ['M1536', 'delta', 'coil', 0xb000],
    ['D100', 'mitsubishi', 'holding-register', 100],
    ['D100', 'omron', 'holding-register', 100],
    ['%MW0', 'wago', 'holding-register', 0x3000],
    ['%QW0', 'wago', 'holding-register', 0x0200],
    ['%MW0', 'twincat', 'holding-register', 0x3000],
    ['%MW2', 'beckhoff-bc', 'holding-register', 0x4001],
    ['N7:0', 'rockwell', 'holding-register', 0],
    ['DB1.DBW10', 'siemens-db', 'holding-register', 5],
  ])('%s of %s', (text, plc, table, address) => {
    expect(readAddress(text)).toContainEqual({ notation: 'plc', plc, table, address });
  });

  it('is told with its controllers, and never taken by itself', () => {
    expect(addressTraps('V2000', reads)).toMatchObject([
      { code: 'plc-device', severity: 'note', got: undefined, plc: 'directlogic', repairs: [{ text: 'HR1025' }] },
    ]);
    expect(addressTraps('D100', reads).map((trap) => 'plc' in trap && trap.plc)).toEqual([
      'delta',
      'mitsubishi',
      'omron',
    ]);
    expect(addressTraps('%MW0', reads)[0]).toMatchObject({ code: 'plc-device', got: 0 });
    // Octal has no digit 8, and bytes of a block are counted in pairs.
    expect(readAddress('V2008')).toEqual([]);
    expect(readAddress('DB1.DBW11')).toEqual([]);
  });
});
