import { describe, expect, it } from 'vitest';
import { framesOf, meant, takenHex } from './meant.ts';

/** The controllers and addresses of a question. */
const controllersOf = (text: string) => {
  const meaning = meant(text);
  const offers = meaning.kind === 'several' ? meaning.offers : [];
  return offers.flatMap((offer) =>
    offer.as === 'address' && offer.plc ? [[offer.plc, offer.table, offer.address]] : [],
  );
};

describe('a name in the program of a controller', () => {
  // Delta DVP: D0 is 0x1000, M0 0x0800. DirectLOGIC counts V in octal: V2000 is 1024. Siemens counts bytes: two are a register.
  it.each([
    [
      'D100',
      [
        ['delta', 'holding-register', 0x1064],
        ['mitsubishi', 'holding-register', 100],
        ['omron', 'holding-register', 100],
      ],
    ],
    [
      'd10',
      [
        ['delta', 'holding-register', 0x100a],
        ['mitsubishi', 'holding-register', 10],
        ['omron', 'holding-register', 10],
      ],
    ],
    ['DM10', [['omron', 'holding-register', 10]]],
    [
      'MW100',
      [
        ['siemens-m', 'holding-register', 50],
        ['schneider', 'holding-register', 100],
      ],
    ],
    ['MD100', [['siemens-m', 'holding-register', 50]]],
    ['DB1.DBW4', [['siemens-db', 'holding-register', 2]]],
    ['DB10.DBD4', [['siemens-db', 'holding-register', 2]]],
    ['V2000', [['directlogic', 'holding-register', 1024]]],
    ['N7:3', [['rockwell', 'holding-register', 3]]],
    [
      'M100',
      [
        ['delta', 'coil', 0x0864],
        ['mitsubishi', 'coil', 100],
      ],
    ],
    [
      'read D100',
      [
        ['delta', 'holding-register', 0x1064],
        ['mitsubishi', 'holding-register', 100],
        ['omron', 'holding-register', 100],
      ],
    ],
  ])('%s is a question: in which', (text, controllers) => {
    expect(controllersOf(text)).toEqual(controllers);
  });

  it.each([
    // Function 06 with the value 5; 03 for eight coils is 01; a double word has two registers.
    ['write 5 to DM10', ['0606000A0005']],
    ['DM10 = 5', ['0606000A0005']],
    ['unit 17 read 3 from V2000', ['110304000003']],
    ['M100 x 8', ['060108640008', '060100640008']],
    ['DB1.DBD4', ['060300020002']],
    ['write 77.5 to DM10', ['0610000A000204429B0000', '0610000A0002040000429B']],
  ])('%s is asked for like any other place', (text, frames) => {
    expect(framesOf(text).map((frame, at) => frame.slice(0, frames[at]?.length))).toEqual(frames);
  });

  it('that is one of IEC 61131 too is taken for that, with the controllers that have it elsewhere', () => {
    expect(takenHex('%MW100').slice(0, 12)).toBe('060300640001');
    // WAGO 0x3000 + 100; TwinCAT 0x3000 + 100 / 2; Beckhoff 0x4000 + 100 / 2.
    expect(framesOf('%MW100').map((frame) => frame.slice(4, 8))).toEqual(['0064', '3064', '3032', '4032']);
  });

  it('is not what looks like two bytes or less, nor one of a number that the controller does not have', () => {
    for (const text of ['D4', 'C5', 'V1999', 'D99999', 'MW101'])
      expect(controllersOf(text).map(([plc]) => plc)).not.toContain('siemens-m');
    expect(controllersOf('D4')).toEqual([]);
    expect(controllersOf('V1999')).toEqual([]);
  });

  it.each(['W100', '%MD100', 'DB1.DBX4.0', 'P9999', 'AI3', 'V1999', 'SM0.5', 'FOO_12'])(
    '%s is not known: what would do is said',
    (name) => {
      expect(meant(name)).toMatchObject({ kind: 'no-bytes', advice: { code: 'name-unknown', name } });
    },
  );

  it.each(['hello', 'hello world', '0x12', 'AB12', 'the frame of unit 3'])('%s is not a name', (text) => {
    expect('advice' in meant(text) && meant(text)).not.toHaveProperty('advice.code');
  });
});

describe('an address that is written twice', () => {
  it.each(['0x1000 (4096)', '4096 (0x1000)', '1000h (4096)', '0x1000(4096)'])('%s is one', (text) => {
    const [address, value] = framesOf(text);
    expect(address?.slice(0, 12)).toBe('060310000001');
    expect(value?.slice(0, 12)).toBe('060602AB1000');
    expect(takenHex(`read ${text}`).slice(0, 12)).toBe('060310000001');
  });

  it.each([
    ['0 (40001)', '060300000001'],
    ['40001 (0)', '060300000001'],
    ['107 (40108)', '0603006B0001'],
  ])('%s has the number that manuals print', (text, frame) => {
    expect(takenHex(text).slice(0, 12)).toBe(frame);
  });
});

describe('the bit of a register', () => {
  it.each([
    ['40001.5', 5, 0],
    ['40001[5]', 5, 0],
    ['40001 bit 5', 5, 0],
    ['40001.A', 10, 0],
    ['HR108.15', 15, 107],
    ['0 (40001)', undefined, 0],
    ['40108', undefined, 107],
    ['%MW100:X3', 3, 100],
    ['bit 5 of 40001', 5, 0],
    ['read bit 5 of HR108', 5, 107],
    ['P0683.5', 5, 683],
    // A coil is a bit.
    ['CO20', undefined, 19],
  ])('%s', (text, bit, address) => {
    expect(meant(text)).toMatchObject({ kind: 'address', taken: { bit, address } });
    const meaning = meant(text);
    expect(meaning.kind === 'address' && 'bit' in meaning.taken && meaning.taken.bit).toBe(bit);
    // The whole register is read.
    const [frame] = framesOf(text);
    expect(frame?.slice(8, 12)).toBe('0001');
  });

  it.each([
    // AP 6.16: the AND mask leaves the other bits, the OR mask has the bit.
    ['write 1 to 40001.5', '06160000FFDF0020'],
    ['set 40001.5 on', '06160000FFDF0020'],
    ['40001.0 = 1', '06160000FFFE0001'],
    ['write 0 to bit 15 of HR108', '0616006B7FFF0000'],
    ['set P0683.5 off', '061602ABFFDF0000'],
    ['unit 17 write true to 40001.3', '11160000FFF70008'],
  ])('is written by a mask: %s', (text, frame) => {
    expect(takenHex(text).slice(0, frame.length)).toBe(frame);
  });

  it('takes no other value', () => {
    expect(framesOf('write 7 to 40001.5')).toEqual([]);
  });
});
