import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { functionCodes, functionsOf, type Table } from '../../../../src/modbus/index.ts';
import { addressTraps } from '../../../../src/notation/index.ts';
import { addressQuantity, mayBeTrapped } from '../../../../src/workbench/frame/address-typed.ts';
import { type Draft, firstDraft } from '../../../../src/workbench/frame/draft.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { repaired, trapsOf } from '../../../../src/workbench/frame/trapped-address.ts';

const request = (texts: Draft['texts']): Draft => ({ ...firstDraft, texts: { unitId: '17', ...texts } });
const path = 'startAddress';
const table = 'holding-register';
const codes = (draft: Draft, typed?: string, convention: Parameters<typeof trapsOf>[2] = 'protocol') => {
  const text = draft.texts[path] ?? '';
  return trapsOf({ path, text, typed: typed ?? text, table }, evaluate(draft), convention).map(({ code }) => code);
};

describe('the traps of an address in a frame', () => {
  it('are those of the function, and of how many items are asked for', () => {
    expect(codes(request({ functionCode: '3', startAddress: '3x9', quantity: '1' }))).toContain('other-table');
    // 65535 and 2 registers: the second would be at 65536, beyond the last address (AP 4.4).
    expect(codes(request({ functionCode: '3', startAddress: '0xFFFF', quantity: '2' }))).toContain('over-end');
    expect(codes(request({ functionCode: '3', startAddress: '0xFFFF', quantity: '1' }))).not.toContain('over-end');
  });

  it("are those of the text as it was typed, if it was typed in the manual's way", () => {
    const draft = request({ functionCode: '3', startAddress: 'HR108', quantity: '1' });
    expect(codes(draft, '108', 'one-based')).toContain('counted-from-zero');
    expect(codes(draft, 'HR108', 'one-based')).not.toContain('counted-from-zero');
  });
});

describe('a repair of an address', () => {
  it('is another text, the function of its table too, or a smaller quantity', () => {
    const draft = request({ functionCode: '3', startAddress: '30009', quantity: '2' });
    const texts = (by: Parameters<typeof repaired>[2]) => repaired(draft, path, by).texts;
    expect(texts({ kind: 'text', text: '0x7539', address: 30009 })).toMatchObject({
      functionCode: '3',
      startAddress: '0x7539',
      quantity: '2',
    });
    expect(texts({ kind: 'function', text: 'IR9', address: 8, functionCode: 4 })).toMatchObject({
      functionCode: '4',
      startAddress: 'IR9',
    });
    expect(texts({ kind: 'quantity', quantity: 1 })).toMatchObject({ startAddress: '30009', quantity: '1' });
  });
});

describe('a text that cannot be in a trap that needs a look', () => {
  const tables: readonly Table[] = ['coil', 'discrete-input', 'input-register', 'holding-register', 'file-record'];
  const places = tables.flatMap((of) => functionsOf(of).map(({ code }) => ({ functionCode: code, table: of })));
  const plain = { convention: 'protocol' } as const;

  it('is in none, whatever the function and the quantity', () => {
    expect(places.length).toBeGreaterThan(functionCodes.length / 2);
    const text = fc.oneof(
      fc.nat(99_999).map(String),
      fc.nat(0xfffff).map((value) => `0x${value.toString(16)}`),
      fc.stringMatching(/^0x\d{1,5}$/),
      fc.stringMatching(/^[0-9x ]{0,6}$/),
    );
    let told = 0;
    fc.assert(
      fc.property(
        text,
        fc.constantFrom(...places),
        fc.option(fc.nat(70_000), { nil: undefined }),
        (typed, at, quantity) => {
          if (mayBeTrapped(typed, quantity, plain)) return;
          told++;
          const warnings = addressTraps(typed, { ...at, quantity }).filter(({ severity }) => severity === 'warning');
          expect(warnings).toEqual([]);
        },
      ),
      { numRuns: 1000 },
    );
    expect(told).toBeGreaterThan(300);
  });

  it('is that of the first frame', () => {
    const { controls, ...evaluated } = evaluate(firstDraft);
    const address = controls.find(({ field }) => field.kind === 'address')!;
    expect(mayBeTrapped(address.text, addressQuantity(evaluated, address.path), plain)).toBe(false);
  });

  it.each([
    ['40108', 1, 'protocol'],
    ['0x00001', 1, 'protocol'],
    ['0108', 1, 'protocol'],
    ['HR108', 1, 'protocol'],
    ['108', 1, 'one-based'],
    ['9999', 55_538, 'protocol'],
  ] as const)('is not %s, with a quantity of %i, if the manual means %s', (text, quantity, convention) => {
    expect(mayBeTrapped(text, quantity, { convention })).toBe(true);
  });
});
