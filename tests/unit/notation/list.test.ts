import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { readBits, readNumbers } from '../../../src/notation/index.ts';

const list = (...items: number[]) => ({ kind: 'list', items });

describe('numbers', () => {
  test.each([
    ['1, 0x2 3h', [1, 2, 3]],
    ['1;2;3', [1, 2, 3]],
    ['1\n2\r\n3\t4', [1, 2, 3, 4]],
    [' , 7 ,, 8 ; ', [7, 8]],
    ['16#FF', [255]],
    ['-1 70000 1.5', [-1, 70000, 1.5]],
    ['', []],
    [' ,; ', []],
  ])('%j', (text, items) => {
    expect(readNumbers(text)).toEqual(list(...items));
  });

  test('the first word that is none is told by its place and by how many came before it', () => {
    expect(readNumbers('1, two, 3, four')).toEqual({
      kind: 'wrong',
      word: { text: 'two', from: 3, to: 6 },
      index: 1,
    });
    expect(readNumbers('0x')).toEqual({ kind: 'wrong', word: { text: '0x', from: 0, to: 2 }, index: 0 });
    expect(readNumbers('1\n2\n3 4x')).toMatchObject({ word: { text: '4x', from: 6, to: 8 }, index: 3 });
  });

  test('any list is read back', () => {
    fc.assert(
      fc.property(fc.array(fc.nat(0xffff)), fc.constantFrom(' ', ',', ', ', ';', '\n', '\t'), (items, between) => {
        expect(readNumbers(items.join(between))).toEqual(list(...items));
      }),
      { numRuns: 200 },
    );
  });
});

describe('bits, the lowest address first', () => {
  test.each([
    ['1011', [1, 0, 1, 1]],
    ['1 0 1 1', [1, 0, 1, 1]],
    ['10 11', [1, 0, 1, 1]],
    ['1,0;1\n1', [1, 0, 1, 1]],
    ['on, off ON Off', [1, 0, 1, 0]],
    ['true false TRUE', [1, 0, 1]],
    ['on 0 true 1', [1, 0, 1, 1]],
    ['', []],
  ])('%j', (text, items) => {
    expect(readBits(text)).toEqual(list(...items));
  });

  test('the first word that is none is told by its place', () => {
    expect(readBits('1 0 2')).toEqual({ kind: 'wrong', word: { text: '2', from: 4, to: 5 }, index: 2 });
    expect(readBits('on, of')).toEqual({ kind: 'wrong', word: { text: 'of', from: 4, to: 6 }, index: 1 });
    expect(readBits('0x1')).toMatchObject({ kind: 'wrong', word: { text: '0x1', from: 0 }, index: 0 });
    expect(readBits('0b101')).toMatchObject({ kind: 'wrong', word: { text: '0b101', from: 0 }, index: 0 });
  });

  test('any bits are read back, with or without blanks', () => {
    fc.assert(
      fc.property(fc.array(fc.constantFrom(0, 1)), fc.constantFrom('', ' ', ', '), (items, between) => {
        expect(readBits(items.join(between))).toEqual(list(...items));
      }),
      { numRuns: 200 },
    );
  });
});
