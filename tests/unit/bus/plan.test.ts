import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { itemsOf, type PlanRules, planReads, requestFor, type Wanted } from '../../../src/bus/index.ts';
import { fromHex, toHex } from '../../../src/modbus/index.ts';

const register = (address: number, size = 1, unit = 1): Wanted => ({ unit, table: 'holding-register', address, size });
const coil = (address: number): Wanted => ({ unit: 1, table: 'coil', address, size: 1 });
const run = (from: number, count: number) => Array.from({ length: count }, (_, index) => register(from + index));
const spans = (wanted: readonly Wanted[], rules?: PlanRules) =>
  planReads(wanted, rules).reads.map(({ address, quantity }) => [address, quantity]);

describe('what is to be read becomes requests', () => {
  it('splits a long read at 125 registers and 2000 bits (AP 6.1, 6.3)', () => {
    expect(spans(run(0, 125))).toEqual([[0, 125]]);
    expect(spans(run(0, 126))).toEqual([
      [0, 125],
      [125, 1],
    ]);
    const bits = Array.from({ length: 2001 }, (_, index) => coil(index));
    expect(spans(bits)).toEqual([
      [0, 2000],
      [2000, 1],
    ]);
  });

  it('keeps to the limits of the device, and never passes those of the specification', () => {
    expect(spans(run(10, 5), { registers: 2 })).toEqual([
      [10, 2],
      [12, 2],
      [14, 1],
    ]);
    expect(spans([coil(0), coil(1), coil(2)], { bits: 2 })).toEqual([
      [0, 2],
      [2, 1],
    ]);
    expect(spans(run(0, 126), { registers: 500 })).toHaveLength(2);
  });

  it('joins neighbours across 8 addresses and no more, or across as many as is said', () => {
    expect(spans([register(0), register(9)])).toEqual([[0, 10]]);
    expect(spans([register(0), register(10)])).toHaveLength(2);
    expect(spans([register(0), register(10)], { gap: 9 })).toEqual([[0, 11]]);
    expect(spans([register(0), register(1), register(3)], { gap: 0 })).toEqual([
      [0, 2],
      [3, 1],
    ]);
  });

  it('never cuts a value in two', () => {
    expect(spans([...run(0, 124), register(124, 2)])).toEqual([
      [0, 124],
      [124, 2],
    ]);
  });

  it('keeps values that overlap in one request', () => {
    // Cut greedily from 0 on, the value at 2 would be in a second request, and address 2 in both.
    expect(spans([register(0), register(1, 2), register(2, 2)], { registers: 3 })).toEqual([
      [0, 1],
      [1, 3],
    ]);
  });

  it('reads units and tables by themselves, in the order they are first wanted in', () => {
    const plan = planReads([register(5, 1, 7), coil(5), register(6, 1, 7), register(5, 1, 1)]);
    expect(plan.reads.map(({ unit, table, address, quantity }) => [unit, table, address, quantity])).toEqual([
      [7, 'holding-register', 5, 2],
      [1, 'coil', 5, 1],
      [1, 'holding-register', 5, 1],
    ]);
    expect(plan.places).toEqual([
      { read: 0, at: 0, size: 1 },
      { read: 1, at: 0, size: 1 },
      { read: 0, at: 1, size: 1 },
      { read: 2, at: 0, size: 1 },
    ]);
  });

  it('says which values no request can read', () => {
    const plan = planReads([register(0, 126), register(0xffff, 2), register(0xffff), register(4, 2)], {
      registers: 126,
    });
    expect(plan.places).toEqual([undefined, undefined, { read: 1, at: 0, size: 1 }, { read: 0, at: 0, size: 2 }]);
  });

  it('counts registers, not addresses, where each address is a value of two', () => {
    const floats = Array.from({ length: 63 }, (_, index): Wanted => ({ ...register(7001 + index), width: 2 }));
    const plan = planReads(floats);
    expect(plan.reads.map(({ address, quantity }) => [address, quantity])).toEqual([
      [7001, 62],
      [7063, 1],
    ]);
    expect(plan.places[1]).toEqual({ read: 0, at: 2, size: 2 });
  });

  const anything = fc.record({
    unit: fc.integer({ min: 1, max: 2 }),
    table: fc.constantFrom('holding-register' as const, 'coil' as const),
    address: fc.oneof(fc.integer({ min: 0, max: 300 }), fc.integer({ min: 65_400, max: 65_540 })),
    size: fc.integer({ min: 1, max: 6 }),
  });

  it('reads every wanted address in exactly one request, none of which is over the limit', () => {
    fc.assert(
      fc.property(
        fc.uniqueArray(anything, {
          maxLength: 120,
          selector: ({ unit, table, address }) => `${unit}${table}${address}`,
        }),
        fc.integer({ min: 1, max: 130 }),
        fc.integer({ min: 0, max: 12 }),
        (all, registers, gap) => {
          // Values that do not overlap: what overlaps in a long chain has to be read twice.
          const wanted = all
            .toSorted((a, b) => a.address - b.address)
            .filter((one, index, sorted) =>
              sorted
                .slice(0, index)
                .every((o) => o.unit !== one.unit || o.table !== one.table || o.address + o.size <= one.address),
            );
          const { reads, places } = planReads(wanted, { registers, gap });
          for (const { table, address, quantity } of reads) {
            expect(quantity).toBeLessThanOrEqual(table === 'coil' ? 2000 : Math.min(125, registers));
            expect(address + quantity).toBeLessThanOrEqual(65_536);
          }
          for (const [index, value] of wanted.entries()) {
            const place = places[index];
            const most = value.table === 'coil' ? 2000 : Math.min(125, registers);
            expect(place === undefined).toBe(value.size > most || value.address + value.size > 65_536);
            if (place === undefined) continue;
            expect(place.size).toBe(value.size);
            expect(reads[place.read]!.address + place.at).toBe(value.address);
            for (let address = value.address; address < value.address + value.size; address++) {
              const found = reads.filter(
                (read) =>
                  read.unit === value.unit &&
                  read.table === value.table &&
                  read.address <= address &&
                  address < read.address + read.quantity,
              );
              expect(found).toEqual([reads[place.read]]);
            }
          }
          if (gap === 0) {
            const asked = reads.reduce((sum, { quantity }) => sum + quantity, 0);
            const held = wanted.reduce((sum, { size }, index) => sum + (places[index] ? size : 0), 0);
            expect(asked).toBe(held);
          }
        },
      ),
    );
  });
});

describe('the way back', () => {
  const read = { unit: 1, table: 'holding-register', address: 10, quantity: 2, width: 1 } as const;
  const request = requestFor(read, 'rtu');
  const reply = (hex: string) => itemsOf(read, request, fromHex(hex) as Uint8Array, 'rtu');

  it('has the request of a read', () => {
    // unit, function code, start address, quantity, CRC
    expect(toHex(request)).toBe('0103000A0002E409');
    // colon, 01 02 000A 0002 and the LRC as characters, CR LF
    expect(toHex(requestFor({ ...read, table: 'discrete-input' }, 'ascii'))).toBe('3A30313032303030413030303246310D0A');
  });

  it('has the registers of a reply', () => {
    // unit, function code, byte count, registers, CRC
    expect(reply('01030403F203F31B31')).toEqual([1010, 1011]);
  });

  it('has nothing from an exception, from a reply of another length, and from a broken one', () => {
    expect(reply('018302C0F1')).toBeUndefined();
    expect(reply('01030203F2389D')).toBeUndefined();
    expect(reply('01030403F203F31B32')).toBeUndefined();
  });
});
