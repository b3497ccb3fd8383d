import { describe, expect, it } from 'vitest';
import { filled, itemsOf, moved } from '../../../../src/workbench/index.ts';

describe('the items of a list', () => {
  it('keep their notation', () => {
    expect(itemsOf('10, 0x0A;\n 0Ah')).toEqual(['10', '0x0A', '0Ah']);
    expect(itemsOf('1 maybe')).toEqual(['1', 'maybe']);
    expect(itemsOf('')).toEqual([]);
  });

  it('are moved, and stay as they are if there is no such item', () => {
    expect(moved(['a', 'b', 'c'], 0, 2)).toEqual(['b', 'c', 'a']);
    expect(moved(['a', 'b', 'c'], 2, 1)).toEqual(['a', 'c', 'b']);
    expect(moved(['a'], 1, 0)).toEqual(['a']);
  });

  it('are made anew, at most 2000', () => {
    expect(filled({ count: 3, value: 10, step: 5 })).toEqual(['10', '15', '20']);
    expect(filled({ count: -1, value: 0, step: 0 })).toEqual([]);
    expect(filled({ count: 5000, value: 0, step: 0 })).toHaveLength(2000);
  });
});
