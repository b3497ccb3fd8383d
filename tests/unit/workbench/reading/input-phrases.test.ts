import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  type Draft,
  evaluate,
  firstDraft,
  type InputMeaning,
  inputMeaning,
  readText,
} from '../../../../src/workbench/index.ts';
import { draftMeant } from '../../../../src/workbench/reading/draft-meant.ts';
import { inputContext } from './input-context.ts';

const meant = (text: string, device?: string, draft?: Draft): InputMeaning =>
  inputMeaning(readText(text, undefined), inputContext(draft, device));
const hex = (draft: Draft | undefined) =>
  draft &&
  Buffer.from(evaluate(draft).frame?.bytes ?? [])
    .toString('hex')
    .toUpperCase();
const taken = (text: string) => hex(draftMeant(meant(text)));
const offered = (text: string): readonly (string | undefined)[] => {
  const meaning = meant(text);
  return meaning.kind === 'several' ? meaning.offers.map(({ draft }) => hex(draft)) : [];
};

/** AP 6.3: a request for registers 108 to 110 of unit 17. */
const THREE_FROM_108 = '1103006B00037687';

describe('unit, function, start and quantity in any order', () => {
  it.each([
    'unit 17 40108-40110',
    '40108–40110 unit 17',
    'slave 17: 40108..40110',
    'unit 17 fc 3 40108, 3',
    'fc 03 unit 17 40108 3',
    'function 3 40108 3 slave 17',
    'function code 0x03, unit id 0x11, 40108 x 3',
    '3 registers from 40108, unit 17',
    'unit=17 read 3 from 40108',
    'read 3 registers from 40108 at unit 17',
    'read holding registers 40108 3 unit 17',
    'station 17 read 40108 count 3',
    'slave 17 func 3 addr 107 count 3',
    'addr 107 len 3 slave 17 fc03',
    'unit 17: 03 40108 3',
    '17/40108..40110',
    '17/40108-40110',
    '17/40108/3',
    '17/03/40108/3',
  ])('%s', (text) => {
    expect(taken(text)).toBe(THREE_FROM_108);
  });

  it('means the same in whatever order the words stand', () => {
    const clauses = fc.constantFrom(
      ['unit 17', 'fc 3', '40108-40110'],
      ['slave 0x11', 'function 03', '40108 x3'],
      ['id 17', 'func 3', '3 registers from 40108'],
    );
    fc.assert(
      fc.property(
        clauses.chain((some) => fc.shuffledSubarray([...some], { minLength: 3 })),
        fc.constantFrom(' ', ', ', '; '),
        (some, between) => {
          expect(taken(some.join(between))).toBe(THREE_FROM_108);
        },
      ),
    );
  });

  it.each([
    ['read 5 from VW800', '060300000005847E'],
    ['06 read 5 from VW800', '060300000005847E'],
    ['P0683 45 Hz unit 9', '090602AB1800F2DA'],
    ['40108 x3', '0603006B000375A0'],
    ['17 40108', '1103006B0001F746'],
    ['fc 16 40001 1 2', '061000000002040001000239DA'],
    ['write registers 40001 1 2', '061000000002040001000239DA'],
    ['fc 10 40001 1 2', '061000000002040001000239DA'],
    ['write 5 to 40108 unit 17', '1106006B00053A85'],
    ['00001-00010', '06010000000ABDBA'],
    ['unit 17', '110602AB1000F6C2'],
    ['unit 17 fc 3', '110300000001869A'],
    ['unit 17 read holding registers', '110300000001869A'],
  ])('%s', (text, frame) => {
    expect(taken(text)).toBe(frame);
  });

  it.each([
    // To read three, or to write the number 3.
    ['40108, 3', ['0603006B000375A0', '0606006B0003B9A0']],
    ['40108 3', ['0603006B000375A0', '0606006B0003B9A0']],
    ['HR108 3', ['0603006B000375A0', '0606006B0003B9A0']],
    ['unit 17, 40108, 3', [THREE_FROM_108, '1106006B0003BA87']],
    // 03 may be the function or the unit.
    ['03 40108 3', ['0603006B000375A0', '0303006B000375F5', '0306006B0003B9F5']],
    // A plain number is an address that counts from 0, or a register that counts from 1.
    ['read 1 from 4', ['060300040001C47C', '06030003000175BD']],
    ['read 4', ['060300040001C47C', '06030003000175BD']],
    ['slave 6 write 683 4096', ['060602AB1000F5E5', '060602AA1000A425']],
    ['unit 6 683 = 4096', ['060602AB1000F5E5', '060602AA1000A425']],
    ['write 4096 to 683', ['060602AB1000F5E5', '060602AA1000A425']],
    ['read coils 20-38', ['0601001400133C74', '0601001300138DB5']],
    ['read holding registers 107 3 unit 17', [THREE_FROM_108, '1103006A00032747']],
    // Here the word says that it is rather the register’s number.
    ['holding register 108', ['0603006B0001F461', '0603006C000145A0']],
    ['write on to coil 20', ['06050013FF007C48', '06050014FF00CD89']],
  ])('%s is offered for what it may be, and nothing is taken', (text, frames) => {
    expect(taken(text)).toBeUndefined();
    expect(offered(text)).toEqual(frames);
  });

  it('0 and what is written in hexadecimal are addresses only', () => {
    expect(taken('read 1 from 0')).toBe('06030000000185BD');
    expect(taken('unit 17 read 3 from 0x6B')).toBe(THREE_FROM_108);
  });

  it.each([
    'unit 17: 11 03 00 6B 00 03',
    'write 06 06 02 AB 10 00',
    '01 03 00',
    '1 2 3',
    'unit 06 06 02 AB 10 00 F5 E5',
  ])('%s are bytes as before', (text) => {
    expect(meant(text).kind).toBe('frames');
  });

  it('counts plain numbers as the manual does that is chosen', () => {
    const context = { ...inputContext(), convention: 'one-based' } as const;
    const meaning = inputMeaning(readText('read 1 from 4', undefined), context);
    expect(hex(draftMeant(meaning))).toBe('06030003000175BD');
  });
});

describe('a function by its code', () => {
  it.each([
    ['2B/0E', 'Read Device Identification'],
    ['43/14', 'Read Device Identification'],
    ['0x2B/0x0E', 'Read Device Identification'],
    ['08/00', 'Return Query Data'],
    ['fc 43', 'Read Device Identification'],
    ['fc 2B', 'Read Device Identification'],
  ])('%s is %s', (text, name) => {
    expect(meant(text)).toMatchObject({ kind: 'function', taken: { name } });
  });

  it.each(['43', '2B', '2b', '0x2B', '2Bh'])('%s is Read Device Identification before CANopen', (text) => {
    const meaning = meant(text);
    const names = meaning.kind === 'several' ? meaning.offers.map((offer) => 'name' in offer && offer.name) : [];
    expect(names.slice(0, 2)).toEqual(['Read Device Identification', 'CANopen General Reference']);
  });
});

describe('a number alone', () => {
  const values = (text: string) => {
    const meaning = meant(text);
    const all = meaning.kind === 'several' ? meaning.offers : meaning.kind === 'value-with-unit' ? meaning.others : [];
    return all.flatMap((offer) => (offer.as === 'number' ? [`${offer.type} ${offer.order} ${hex(offer.draft)}`] : []));
  };

  it.each([
    // Written where the frame writes, which is register 683 of unit 6; two registers with function 16.
    ['-5', ['i16 ABCD 060602ABFFFBF856', 'f32 ABCD 061002AB000204C0A000008752']],
    ['77.5', ['f32 ABCD 061002AB000204429B0000DEE7', 'f32 CDAB 061002AB0002040000429BCA7B']],
    ['77,5', ['f32 ABCD 061002AB000204429B0000DEE7', 'f32 CDAB 061002AB0002040000429BCA7B']],
    [
      '70000',
      [
        'u32 ABCD 061002AB00020400011170E704',
        'u32 CDAB 061002AB000204117000017E57',
        'f32 ABCD 061002AB0002044788B8005DEE',
      ],
    ],
    ['-1.5 °C', ['f32 ABCD 061002AB000204BFC000009E98', 'f32 CDAB 061002AB0002040000BFC0CB10']],
    ['1.5, 2.5', ['f32 ABCD 061002AB0004083FC00000402000000772', 'f32 CDAB 061002AB00040800003FC000004020A526']],
  ])('%s is offered as values', (text, all) => {
    expect(values(text)).toEqual(all);
  });

  it.each(['-1', '+5', '0.5', '1e3', '3.14', '65536', '-70000', '1000000', '4294967295', '−40', '99999'])(
    '%s is never without a meaning, and takes the place of nothing',
    (text) => {
      expect(values(text).length).toBeGreaterThan(0);
      expect(meant(text).kind).toBe('several');
    },
  );

  it('has a unit that is told if nothing here knows it', () => {
    expect(meant('-1.5 °C')).toMatchObject({ kind: 'value-with-unit', unknown: '°C' });
    expect(meant('45 Hz', 'weg-drive')).toMatchObject({ kind: 'value-with-unit', unknown: undefined });
  });

  it('that says its type is taken', () => {
    expect(taken('f32 77.5')).toBe('061002AB000204429B0000DEE7');
    expect(taken('i16 -5')).toBe('060602ABFFFBF856');
  });

  it('goes to the register that the frame reads, if it writes none', () => {
    const read: Draft = {
      ...firstDraft,
      texts: { unitId: '17', functionCode: '3', startAddress: '107', quantity: '1' },
    };
    const meaning = meant('-5', undefined, read);
    expect(meaning.kind === 'several' && hex(meaning.offers[0]?.draft)).toBe('1106006BFFFBFAF5');
  });
});

describe('the number of a register', () => {
  it.each([
    ['401000', true],
    ['401000–401003', true],
    ['41000', false],
    ['HR1000', false],
  ])('%s is called as it was typed', (text, sixDigits) => {
    expect(meant(text)).toMatchObject({ taken: { address: 999, sixDigits } });
  });
});

describe('a device that a text chooses', () => {
  it('is told, with the one before', () => {
    expect(meant('P0683 45 Hz')).toMatchObject({ chooses: { device: { id: 'weg-drive' }, before: '' } });
    expect(meant('P0683', 's7-200')).toMatchObject({ chooses: { device: { id: 'weg-drive' }, before: 's7-200' } });
  });

  it('is not told where it was chosen already, or none is', () => {
    expect(meant('P0683 45 Hz', 'weg-drive')).toMatchObject({ chooses: undefined });
    expect(meant('40108')).toMatchObject({ chooses: undefined });
  });
});
