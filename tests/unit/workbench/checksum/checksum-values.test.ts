import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type Checksum, checksum, checksums, crcChecksum, ownCrc } from '../../../../src/modbus/index.ts';
import {
  checksumValues,
  digestInput,
  joinedValues,
  tellChecksum,
  toldChecksum,
} from '../../../../src/workbench/checksum/checksum-values.ts';
import { hex } from '../../modbus/frames.ts';

describe('the values of all checksums', () => {
  it('are those that catalogues print for 123456789', () => {
    const { reading, values } = digestInput('123456789', 'text');
    expect(reading.bytes).toEqual(hex('31 32 33 34 35 36 37 38 39'));
    expect(values).toMatchObject({ 'CRC-16/MODBUS': 0x4b37, LRC: 0x23, 'CRC-32/ISO-HDLC': 0xcbf43926 });
    expect(Object.keys(checksumValues(hex('02 07')))).toHaveLength(checksums.length);
    expect(digestInput('02 07', 'bytes').values['CRC-16/MODBUS']).toBe(0x1241);
  });
});

describe('a checksum told to a worker', () => {
  it('is the same there, with a name or without', () => {
    for (const one of checksums) expect(toldChecksum(tellChecksum(one))).toBe(one);
    const own = crcChecksum(
      ownCrc('own', { width: 16, poly: 0x8005, init: 0xffff, refin: true, refout: true, xorout: 0 }),
    );
    expect(checksum(toldChecksum(tellChecksum(own)), hex('02 07'))).toBe(0x1241);
  });

  it('has a name that there is', () => {
    expect(() => toldChecksum('CRC-16/PURPLE')).toThrow(RangeError);
    expect(() => toldChecksum('constructor')).toThrow(RangeError);
  });
});

describe('parts worked on side by side', () => {
  const joinable: readonly Checksum[] = checksums.filter(({ join }) => join);
  const partsOf = (bytes: Uint8Array, cuts: readonly number[]) =>
    [...cuts, bytes.length].map((to, index) => {
      const part = bytes.subarray(index === 0 ? 0 : cuts[index - 1], to);
      return { size: part.length, states: joinable.map((one) => one.add(index === 0 ? one.start : 0, part)) };
    });

  it('give the value of the whole: 02 07 in two parts has the CRC 0x1241', () => {
    expect(joinedValues(joinable, partsOf(hex('02 07'), [1]))['CRC-16/MODBUS']).toBe(0x1241);
    expect(joinedValues(joinable, partsOf(hex('31 32 33 34 35 36 37 38 39'), [2, 2, 7]))).toMatchObject({
      'CRC-16/MODBUS': 0x4b37,
      LRC: 0x23,
    });
  });

  it('give it for any bytes, cut anywhere', () => {
    fc.assert(
      fc.property(fc.uint8Array({ maxLength: 40 }), fc.array(fc.nat(40), { maxLength: 3 }), (bytes, places) => {
        const cuts = places.map((place) => Math.min(place, bytes.length)).toSorted((a, b) => a - b);
        const values = joinedValues(joinable, partsOf(bytes, cuts));
        for (const one of joinable) expect(values[one.name], one.name).toBe(checksum(one, bytes));
      }),
      { numRuns: 30 },
    );
  });
});
