import fc from 'fast-check';
import { describe, expect, it, test } from 'vitest';
import { counterpart, functionCodes, functionsOf, quantityOf } from '../../../src/modbus/index.ts';
import {
  type AddressPlace,
  addressConventions,
  addressMeant,
  addressTraps,
  zeroBasedAddress,
} from '../../../src/notation/index.ts';

const reads = { functionCode: 0x03, table: 'holding-register' } as const;
const readsInputs = { functionCode: 0x04, table: 'input-register' } as const;
const coils = { functionCode: 0x01, table: 'coil' } as const;

const codes = (text: string, place: AddressPlace) =>
  addressTraps(text, place).map(({ code, severity }) => `${severity} ${code}`);
const trap = (text: string, place: AddressPlace, code: string) =>
  addressTraps(text, place).find((found) => found.code === code);

describe('the traps by name', () => {
  it('40108 typed where an address from 0 is meant: register 108, or address 40108', () => {
    expect(addressTraps('40108', reads)[0]).toEqual({
      code: 'number-as-address',
      severity: 'warning',
      text: '40108',
      got: 40108,
      table: 'holding-register',
      address: 107,
      repairs: [
        { kind: 'text', text: 'HR108', address: 107 },
        { kind: 'text', text: '0x9CAC', address: 40108 },
      ],
    });
  });

  it('107 or 108: either way round', () => {
    expect(addressTraps('108', reads)).toMatchObject([
      { code: 'counted-from-one', severity: 'note', got: 108, address: 107, repairs: [{ text: 'HR108' }] },
    ]);
    expect(addressTraps('107', { ...reads, readAs: 'one-based' })).toMatchObject([
      { code: 'counted-from-zero', severity: 'note', got: 106, address: 107, repairs: [{ text: '0x006B' }] },
    ]);
  });

  it('a 3x number with 03, and a 4x number with 04', () => {
    expect(trap('3x9', reads, 'other-table')).toMatchObject({
      severity: 'warning',
      named: 'input-register',
      address: 8,
      functions: [0x04],
      repairs: [
        { kind: 'function', functionCode: 0x04, text: 'IR9' },
        { kind: 'text', text: 'HR9' },
      ],
    });
    expect(trap('30009', reads, 'number-as-address')).toMatchObject({
      table: 'input-register',
      repairs: [{ kind: 'function', functionCode: 0x04, text: 'IR9' }, { text: '0x7539' }],
    });
    expect(trap('40108', readsInputs, 'number-as-address')).toMatchObject({
      table: 'holding-register',
      repairs: [{ kind: 'function', functionCode: 0x03, text: 'HR108' }, { text: '0x9CAC' }],
    });
    expect(trap('400108', readsInputs, 'other-table')).toMatchObject({ named: 'holding-register', address: 107 });
    expect(trap('CO5', { functionCode: 0x02, table: 'discrete-input' }, 'other-table')).toMatchObject({
      functions: [0x01, 0x05, 0x0f],
      repairs: [{ functionCode: 0x01 }, { text: 'DI5' }],
    });
    // Nothing writes input registers: the same place among the holding registers is all there is.
    expect(trap('3x9', { functionCode: 0x06, table: 'holding-register' }, 'other-table')?.repairs).toEqual([
      { kind: 'text', text: 'HR9', address: 8 },
    ]);
    // 12289 is an address like another: reading discrete inputs is too far from reading registers.
    expect(codes('12289', reads)).toEqual(['note counted-from-one']);
  });

  it('five digits past 9999', () => {
    expect(trap('50001', { ...reads, readAs: 'digits' }, 'past-five-digits')).toMatchObject({
      severity: 'warning',
      address: 10000,
      repairs: [{ text: 'HR10001' }, { text: 'HR50001' }],
    });
    expect(trap('50001', reads, 'past-five-digits')).toMatchObject({ severity: 'note', got: 50001, address: 10000 });
    expect(
      trap('20000', { functionCode: 0x02, table: 'discrete-input', readAs: 'digits' }, 'past-five-digits'),
    ).toMatchObject({ address: 9999, repairs: [{ text: 'DI10000' }, {}] });
  });

  it('0x of coils against 0x of hexadecimal', () => {
    expect(trap('0x108', coils, 'coil-or-hex')).toMatchObject({
      severity: 'note',
      got: 0x108,
      address: 107,
      repairs: [{ text: 'CO108' }, { text: '16#0108', address: 0x108 }],
    });
    expect(trap('0x00108', coils, 'coil-or-hex')).toMatchObject({ severity: 'warning' });
    expect(trap('0x10000', coils, 'coil-or-hex')).toMatchObject({ got: undefined, repairs: [{ text: 'CO10000' }] });
    expect(trap('0x00108', { ...coils, readAs: 'digits' }, 'coil-or-hex')).toMatchObject({ got: 107, address: 0x108 });
    expect(codes('0x108', reads)).toEqual([]);
    expect(codes('0x6B', coils)).toEqual([]);
  });

  it('leading zeros', () => {
    expect(trap('00108', coils, 'leading-zeros')).toMatchObject({
      severity: 'warning',
      got: 108,
      address: 107,
      repairs: [{ text: 'CO108' }, { text: '16#006C' }],
    });
    expect(trap('000108', coils, 'leading-zeros')).toMatchObject({ got: 108, address: 107 });
    expect(trap('00108', reads, 'leading-zeros')).toMatchObject({ severity: 'note', repairs: [{ text: '0x006C' }] });
  });

  it('no register has number 0', () => {
    expect(trap('40000', reads, 'number-zero')).toMatchObject({ repairs: [{ text: 'HR1' }, { text: '0x9C40' }] });
    expect(trap('0', { ...reads, readAs: 'one-based' }, 'number-zero')).toMatchObject({ repairs: [{ text: 'HR1' }] });
    expect(codes('0', reads)).toEqual([]);
  });

  it('address and quantity over the end (AP 4.4)', () => {
    const most = { ...reads, quantityFree: true };
    expect(codes('65535', { ...most, quantity: 1 })).not.toContain('warning over-end');
    expect(trap('65535', { ...most, quantity: 2 }, 'over-end')).toMatchObject({
      got: 65535,
      quantity: 2,
      repairs: [{ kind: 'quantity', quantity: 1 }],
    });
    expect(trap('465536', { ...reads, quantity: 2 }, 'over-end')).toMatchObject({ got: 65535, repairs: [] });
  });

  it('a manual that prints a 4 before addresses from 0', () => {
    expect(trap('40108', reads, 'digit-from-zero')).toMatchObject({ address: 108, repairs: [{ text: 'HR109' }] });
    expect(trap('40108', { ...reads, readAs: 'digits' }, 'digit-from-zero')).toMatchObject({ got: 107, address: 108 });
    expect(trap('40108', { ...reads, readAs: 'digit-from-zero' }, 'digit-from-one')).toMatchObject({
      got: 108,
      address: 107,
    });
  });

  it('what a frame already holds, where the manual would mean something else by it', () => {
    expect(addressTraps('107', { ...reads, manual: 'one-based' })).toMatchObject([
      { code: 'not-as-in-manual', got: 107, address: 106, repairs: [{ text: 'HR108' }, { text: 'HR107' }] },
    ]);
    expect(addressTraps('HR108', { ...reads, manual: 'one-based' })).toEqual([]);
  });
});

test('what names its table, and hexadecimal, is in no trap for its own function', () => {
  for (const text of ['4x108', '4:108', 'HR108', '0x6B', '6Bh', '16#6B']) expect(codes(text, reads)).toEqual([]);
});

test('every repair says what it does, and is no warning after it is done', () => {
  const typed = fc.oneof(
    fc.stringMatching(/^(0x|[01346]x|HR|CO|IR|DI|%MW|%QX)?0{0,2}\d{1,6}$/),
    fc.integer({ min: 0, max: 65535 }).map(String),
  );
  const functions = functionCodes.filter(({ code }) => [1, 2, 3, 4, 5, 6, 0x0f, 0x10, 0x16, 0x17, 0x18].includes(code));
  fc.assert(
    fc.property(
      typed,
      fc.constantFrom(...functions),
      fc.constantFrom(...addressConventions),
      (text, { code }, readAs) => {
        const table = functionCodes.flatMap((one) => (one.code === code && 'table' in one ? [one.table] : []))[0]!;
        for (const { repairs } of addressTraps(text, { functionCode: code, table, readAs })) {
          for (const repair of repairs) {
            if (repair.kind === 'quantity') continue;
            expect(zeroBasedAddress(repair.text)).toBe(repair.address);
            const to = repair.kind === 'function' ? repair.functionCode : code;
            const of = functionCodes.flatMap((one) => (one.code === to && 'table' in one ? [one.table] : []))[0]!;
            // Whatever manual is at hand, the text means the same from now on.
            expect(addressMeant(repair.text, readAs, of)?.address).toBe(repair.address);
            const left = addressTraps(repair.text, { functionCode: to, table: of, manual: readAs });
            expect(left.filter(({ severity, code: left }) => severity === 'warning' && left !== 'over-end')).toEqual(
              [],
            );
          }
        }
      },
    ),
  );
});

test('any text is answered', () => {
  fc.assert(
    fc.property(fc.string(), fc.constantFrom(...addressConventions), (text, manual) => {
      expect(addressTraps(text, { ...coils, manual }).length).toBeLessThan(8);
    }),
  );
});

describe('functions by table', () => {
  it('are those of AP 6', () => {
    const of = (table: Parameters<typeof functionsOf>[0]) => functionsOf(table).map(({ code }) => code);
    expect(of('coil')).toEqual([0x01, 0x05, 0x0f]);
    expect(of('discrete-input')).toEqual([0x02]);
    expect(of('input-register')).toEqual([0x04]);
    expect(of('holding-register')).toEqual([0x03, 0x06, 0x10, 0x16, 0x17, 0x18]);
    expect(of('file-record')).toEqual([0x14, 0x15]);
  });

  it('have counterparts with the same fields', () => {
    expect(counterpart(0x03, 'input-register')?.code).toBe(0x04);
    expect(counterpart(0x04, 'holding-register')?.code).toBe(0x03);
    expect(counterpart(0x01, 'discrete-input')?.code).toBe(0x02);
    expect(counterpart(0x10, 'input-register')).toBeUndefined();
    expect(counterpart(0x03, 'file-record')).toBeUndefined();
  });

  it('ask for a quantity from an address', () => {
    expect(quantityOf('startAddress')).toBe('quantity');
    expect(quantityOf('readStartAddress')).toBe('readQuantity');
    expect(quantityOf('writeStartAddress')).toBe('writeQuantity');
    expect(quantityOf('address')).toBeUndefined();
  });
});
