import fc from 'fast-check';
import { expect, it } from 'vitest';
import { type Column, countsColumn, indexColumn, timesColumn } from '../../../src/trace/index.ts';

const listOf = (column: Column) => Array.from({ length: column.length }, (_, index) => column.at(index));

it('has what was put into it, whatever type each piece of it has', () => {
  const column = indexColumn();
  // Three pieces of 16,384: of one byte, of two, and of four and more.
  const values = Array.from({ length: 50_000 }, (_, at) =>
    at < 16_384 ? (at % 256) - 1 : at < 32_768 ? at : at * 4e6,
  );
  for (const value of values) column.push(value);
  expect(listOf(column)).toEqual(values);
  column.set(3, 70_000);
  column.set(16_384, -1);
  column.cut(16_385);
  column.push(0xffffffff);
  expect([3, 4, 16_384, 16_385].map((at) => column.at(at))).toEqual([70_000, 3, -1, 0xffffffff]);
  expect(column.length).toBe(16_386);
  column.cut(0);
  column.push(5);
  expect(listOf(column)).toEqual([5]);
});

it('keeps times as they are, and those that nobody knows', () => {
  const column = timesColumn();
  const values = [1.7e15, 0.25, Number.NaN, -1, 0];
  for (const value of values) column.push(value);
  expect(listOf(column)).toEqual(values);
});

it('is like a list, whatever is done with it', () => {
  const anyValue = fc.oneof(fc.nat(300), fc.nat(0xffffffff));
  const anyAct = fc.oneof(
    fc.record({ act: fc.constant('push' as const), value: anyValue, times: fc.constantFrom(1, 60, 20_000) }),
    fc.record({ act: fc.constant('set' as const), value: anyValue, times: fc.nat() }),
    fc.record({ act: fc.constant('cut' as const), value: fc.nat(), times: fc.constant(1) }),
  );
  fc.assert(
    fc.property(fc.array(anyAct, { maxLength: 12 }), (acts) => {
      const column = countsColumn();
      let list: number[] = [];
      for (const { act, value, times } of acts) {
        if (act === 'push') {
          for (let n = 0; n < times; n++) {
            list.push(value);
            column.push(value);
          }
        } else if (act === 'cut') {
          list = list.slice(0, value % (list.length + 1));
          column.cut(list.length);
        } else if (list.length > 0) {
          list[times % list.length] = value;
          column.set(times % list.length, value);
        }
      }
      expect(listOf(column)).toEqual(list);
    }),
    { numRuns: 40 },
  );
});
