import fc from 'fast-check';
import { describe, expect, test } from 'vitest';
import { type NameRules, Names } from '../../../src/codegen/names.ts';

const camel: NameRules = {
  styles: { routine: 'camel', variable: 'camel', constant: 'constant', table: 'constant', type: 'pascal' },
  reserved: ['len', 'type', 'step', 'value'],
};
const snake: NameRules = {
  styles: { routine: 'snake', variable: 'snake', constant: 'constant', table: 'constant', type: 'pascal' },
  reserved: ['Len', 'time'],
  ignoresCase: true,
  most: 20,
};

describe('names', () => {
  test.each([
    [camel, 'routine', 'build write 683 4096', 'buildWrite683_4096'],
    [camel, 'variable', 'start address', 'startAddress'],
    [camel, 'constant', 'fault too short', 'FAULT_TOO_SHORT'],
    [camel, 'type', 'reply', 'Reply'],
    [snake, 'variable', 'start address', 'start_address'],
    [camel, 'variable', 'len', 'lenValue'],
    [camel, 'variable', 'value', 'valueNumber'],
    [snake, 'variable', 'LEN', 'len_value'],
    [camel, 'variable', '30 hz', 'value30Hz'],
    [camel, 'variable', 'Größe in °C', 'groesseInC'],
    [camel, 'variable', '速度', 'valueNumber'],
    [camel, 'routine', '"; */ drop', 'drop'],
    [snake, 'routine', 'check read holding registers', 'check_read_holding'],
  ] as const)('%#: %s %s → %s', (rules, kind, words, expected) => {
    expect(new Names(rules).of(words, kind)).toBe(expected);
  });

  test('the same words have the same name, others another one', () => {
    const names = new Names(snake);
    const first = names.of('check read holding registers', 'routine');
    const second = names.of('check read holding registers of two', 'routine');
    expect(names.of('check read holding registers', 'routine')).toBe(first);
    expect(second).not.toBe(first);
    // Upper and lower case are one here.
    expect(names.of('crc table', 'table').toLowerCase()).not.toBe(names.of('crc table', 'variable').toLowerCase());
  });

  test('what stands in texts of a target keeps its name, and says so', () => {
    const names = new Names(camel, { frame: 'mine' });
    names.keep('frame', 'variable');
    expect(names.of('frame', 'variable')).toBe('frame');
    expect(names.notes).toEqual([{ code: 'name-changed', from: 'mine', to: 'frame' }]);
  });

  test('names of one’s own take the place of the usual ones, as they are if that may be', () => {
    const names = new Names(camel, { startAddress: 'AdrA', quantity: '2 Stück', unit: 'type' });
    expect([
      names.of('start address', 'variable'),
      names.of('quantity', 'variable'),
      names.of('unit', 'variable'),
    ]).toEqual(['AdrA', 'value2Stueck', 'typeValue']);
    expect(names.notes).toEqual([
      { code: 'name-changed', from: '2 Stück', to: 'value2Stueck' },
      { code: 'name-changed', from: 'type', to: 'typeValue' },
    ]);
  });

  test('whatever is typed, a name is valid, not too long, not reserved, and nobody else’s', () => {
    const text = fc.string({ unit: 'grapheme', maxLength: 40 });
    fc.assert(
      fc.property(
        fc.array(fc.tuple(text, text), { minLength: 1, maxLength: 30 }),
        fc.constantFrom(camel, snake),
        (all, rules) => {
          const own = Object.fromEntries(all.map(([, to], index) => [`given${index}`, to]));
          const names = new Names(rules, own);
          const words = new Set([...all.map(([from]) => from), ...all.map((_, index) => `given${index}`)]);
          const made = [...words].map((one) => names.of(one, 'variable'));
          for (const one of made) {
            expect(one).toMatch(/^[A-Za-z]\w*$/);
            expect(one.length).toBeLessThanOrEqual(rules.most ?? 1000);
            expect(rules.reserved.map((word) => word.toLowerCase())).not.toContain(
              rules.ignoresCase ? one.toLowerCase() : one,
            );
          }
          expect(new Set(made.map((one) => (rules.ignoresCase ? one.toLowerCase() : one))).size).toBe(words.size);
        },
      ),
    );
  });
});
