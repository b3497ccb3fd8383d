import fc from 'fast-check';
import { describe, expect, it, test } from 'vitest';
import { type LogBytes, readLongLog, readShortLog } from '../../../src/captures/long-log.ts';
import { crc16, toHex } from '../../../src/modbus/index.ts';
import { dialects, type Entry, write } from '../notation/dialects.ts';

/** What is read, with its places, chunk by chunk. */
const told = ({ bytes, chunks, problems, place }: LogBytes) => ({
  chunks: chunks.map(({ from, to, ...label }) => [toHex(bytes.subarray(from, to)), place(from, to), label]),
  problems: problems.toSorted((a, b) => a.start - b.start || a.end - b.end),
});

const rtu = (...bytes: number[]): Uint8Array => {
  const crc = crc16(Uint8Array.from(bytes));
  return Uint8Array.of(...bytes, crc & 0xff, crc >> 8);
};

/** Requests for registers and their replies, some of them damaged. */
function exchanges(count: number, isDamaged: (index: number) => boolean): Entry[] {
  return Array.from({ length: 2 * count }, (_, index) => {
    const [unit, number] = [1 + ((index >> 1) % 9), index >> 1];
    const bytes =
      index % 2 === 0
        ? rtu(unit, 3, number >> 8, number & 255, 0, 2)
        : rtu(unit, 3, 4, number & 255, 0, (7 * number) & 255, index & 255);
    if (isDamaged(index)) bytes[3] = (bytes[3] ?? 0) ^ 0x40;
    return { side: index % 2 === 0 ? 'tx' : 'rx', bytes };
  });
}

describe('a log of many lines is read as one of few is', () => {
  test.each(dialects)('%s', (_, dialect) => {
    const { text } = write(
      dialect,
      exchanges(40, (index) => index % 17 === 5),
    );
    expect(told(readLongLog(text, undefined, 16))).toEqual(told(readShortLog(text)));
  });

  it('with a time before each line, and anything between', () => {
    const others = [
      '',
      'Timeout',
      '-- 3 retries --',
      '10:31:07 TX 01 03 00',
      '01 02',
      'Error: CRC 0x1234',
      '# restarted',
    ];
    const line = fc.record({
      after: fc.nat(4000),
      isDamaged: fc.nat(9).map((one) => one === 0),
      other: fc.option(fc.constantFrom(...others), { freq: 6 }),
    });
    fc.assert(
      fc.property(
        fc.array(line, { minLength: 30, maxLength: 120 }),
        fc.integer({ min: 12, max: 40 }),
        (lines, learned) => {
          let time = Date.UTC(2026, 10, 30, 9, 59, 30);
          const text = exchanges(lines.length, (index) => lines[index >> 1]!.isDamaged && index % 2 === 1)
            .flatMap(({ side, bytes }, index) => {
              const { after, other } = lines[index >> 1]!;
              time += after;
              const clock = new Date(time).toISOString().slice(11, 23);
              const pairs = Array.from(bytes, (byte) => toHex(Uint8Array.of(byte))).join(' ');
              return [...(other === null ? [] : [other]), `${clock.replace(/^0/, '')} ${side.toUpperCase()} ${pairs}`];
            })
            .join('\n');
          expect(told(readLongLog(text, undefined, learned))).toEqual(told(readShortLog(text)));
        },
      ),
      { numRuns: 40 },
    );
  });
});
