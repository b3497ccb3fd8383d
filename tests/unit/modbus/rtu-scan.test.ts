import fc from 'fast-check';
import { expect, test } from 'vitest';
import { crc16, framesAt, RtuScan } from '../../../src/modbus/index.ts';
import { anyBytes, directions } from './arbitraries.ts';
import { hex } from './frames.ts';
import { asRtu, bitwiseCrc } from './reference.ts';
import { frames } from './vectors.ts';

const READ = hex('01 03 01 80 00 0A C5 D9');

test('the next place, and the end there in each direction', () => {
  const scan = new RtuScan(Uint8Array.of(0xff, ...READ, 0xff, ...hex('11 81 01 8055'), 0xff));
  expect([0, 1, 2, 10, 11].map((from) => scan.next(from))).toEqual([1, 1, 10, 10, 16]);
  expect(directions.map((direction) => scan.endAt(1, direction))).toEqual([9, 0]);
  expect(directions.map((direction) => scan.endAt(10, direction))).toEqual([0, 15]);
  expect([0, 1, 9, 10, 15, 16, 99].map((at) => scan.begins(at))).toEqual([
    false,
    true,
    false,
    true,
    false,
    false,
    false,
  ]);
});

test('no bytes, and too few', () => {
  for (let length = 0; length < READ.length; length++) {
    const scan = new RtuScan(READ.subarray(0, length));
    expect(scan.next(0)).toBe(length);
    expect(scan.endAt(0, 'request')).toBe(0);
  }
});

test('frames of every length, far from the end of the bytes', () => {
  // A reply of 11 has as many bytes as its count says.
  for (let count = 1; count <= 251; count++) {
    const frame = asRtu(7, [0x11, count, ...Array.from({ length: count }, (_, i) => (i * 37) & 0xff)]);
    const scan = new RtuScan(
      Uint8Array.of(...new Array<number>(9).fill(0x41), ...frame, ...new Array<number>(300).fill(0x41)),
    );
    expect(scan.next(0)).toBe(9);
    expect(scan.endAt(9, 'response')).toBe(9 + frame.length);
  }
});

const someFrames = fc.constantFrom(
  ...frames.filter(({ transport }) => transport === 'rtu').map((frame) => hex(frame.hex)),
);

test('any bytes: it says the places and the ends that framesAt says', () => {
  fc.assert(
    fc.property(fc.array(fc.oneof(anyBytes, someFrames), { maxLength: 6 }), (parts) => {
      const bytes = Uint8Array.from(parts.flatMap((part) => [...part]));
      const scan = new RtuScan(bytes);
      let next = scan.next(0);
      for (let at = 0; at < bytes.length; at++) {
        const found = framesAt(bytes, at, bytes.length, 'rtu');
        for (const direction of directions) {
          const first = found.find((frame) => frame.direction === direction)?.to ?? 0;
          if (scan.endAt(at, direction) !== first) expect(scan.endAt(at, direction)).toBe(first);
        }
        if (next < at) next = scan.next(at);
        if (found.length > 0 !== (next === at)) expect.unreachable(`${found.length} at ${at}, but next is ${next}`);
      }
    }),
    { numRuns: 300 },
  );
});

test('a CRC goes on from the bytes before', () => {
  fc.assert(
    fc.property(fc.uint8Array({ maxLength: 300 }), fc.nat(300), (bytes, cut) => {
      const middle = Math.min(cut, bytes.length);
      expect(crc16(bytes, middle, bytes.length, crc16(bytes, 0, middle))).toBe(bitwiseCrc(bytes));
    }),
  );
});
