import { describe, expect, it } from 'vitest';
import { framesOf, meant, takenHex } from './meant.ts';

/** Frames of a question, without their CRC. */
const asked = (text: string) =>
  meant(text).kind === 'several' ? framesOf(text).map((frame) => frame.slice(0, -4)) : [];
const taken = (text: string) => takenHex(text).slice(0, -4);

describe('a value that needs several registers', () => {
  // 77.5 is 0x429B0000 in IEEE 754, 1.5 is 0x3FC00000, 2 is 0x40000000, 70000 is 0x00011170, -32769 is 0xFFFF7FFF.
  it.each([
    ['write 77.5 to 40108', ['0610006B000204429B0000', '0610006B0002040000429B']],
    ['write 77,5 to 40108', ['0610006B000204429B0000', '0610006B0002040000429B']],
    ['HR108 = 77.5', ['0610006B000204429B0000', '0610006B0002040000429B']],
    ['77.5 to 40108', ['0610006B000204429B0000', '0610006B0002040000429B']],
    ['fc 16 write 77.5 to 40108', ['0610006B000204429B0000', '0610006B0002040000429B']],
    ['unit 17 write 77.5 to 40108', ['1110006B000204429B0000', '1110006B0002040000429B']],
    ['write 1.5 2 to 40108', ['0610006B0004083FC0000040000000', '0610006B00040800003FC000004000']],
    // 70000 as a float is 0x4788B800.
    ['write 70000 to 40108', ['0610006B00020400011170', '0610006B00020411700001', '0610006B0002044788B800']],
    ['write 65536 to 40108', ['0610006B00020400010000', '0610006B00020400000001', '0610006B00020447800000']],
    ['write -32769 to 40108', ['0610006B000204FFFF7FFF', '0610006B0002047FFFFFFF', '0610006B000204C7000100']],
    [
      'write 77.5 to 107',
      ['0610006B000204429B0000', '0610006B0002040000429B', '0610006A000204429B0000', '0610006A0002040000429B'],
    ],
  ])('%s asks for the order of its words', (text, frames) => {
    expect(asked(text)).toEqual(frames);
  });

  it.each([
    ['write "PUMP" to 40108', '0610006B00020450554D50'],
    ['40108 = “PUMP”', '0610006B00020450554D50'],
    ["write 'AB' to HR108", '0606006B4142'],
    ['write f32 CDAB 77.5 to 40108', '0610006B0002040000429B'],
    ['write i16 -5 to 40108', '0606006BFFFB'],
  ])('%s has its type', (text, frame) => {
    expect(taken(text)).toBe(frame);
  });

  it('does not fit the function that writes one: those that do are offered', () => {
    expect(meant('fc 6 write 77.5 to 40108').kind).toBe('address');
    expect(framesOf('fc 6 write 77.5 to 40108').map((frame) => frame.slice(0, -4))).toEqual([
      '',
      '0610006B000204429B0000',
      '0610006B0002040000429B',
    ]);
  });
});

describe('a value that fits a register', () => {
  it.each([
    ['write 5 to 40108', '0606006B0005'],
    ['write 65535 to 40108', '0606006BFFFF'],
    ['write 0x1000 to 40108', '0606006B1000'],
    ['write 10 258 to HR2', '06100001000204000A0102'],
    // Two's complement.
    ['write -5 to 40108', '0606006BFFFB'],
    ['write −32768 to 40108', '0606006B8000'],
    ['write -1 -2 to 40108', '0610006B000204FFFFFFFE'],
  ])('%s is written as it is', (text, frame) => {
    expect(taken(text)).toBe(frame);
  });

  it('may be a float too, where it is negative', () => {
    expect(framesOf('write -5 to 40108').map((frame) => frame.slice(0, -4))).toEqual([
      '0606006BFFFB',
      '0610006B000204C0A00000',
    ]);
  });
});

describe('what nothing writes', () => {
  it.each([
    ['write 5 to 30001', 'input-register'],
    ['write 77.5 to 30001', 'input-register'],
    ['set IR4 = 2', 'input-register'],
    ['write on to 10197', 'discrete-input'],
    ['set DI5 off', 'discrete-input'],
  ])('%s is said to be so', (text, table) => {
    expect(meant(text)).toMatchObject({ kind: 'no-bytes', advice: { code: 'read-only', table } });
  });
});
