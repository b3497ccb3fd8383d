import { describe, expect, it } from 'vitest';
import { builtInProfiles } from '../../../../src/devices/index.ts';
import type { Table } from '../../../../src/modbus/index.ts';
import { languages } from '../../../../src/words/index.ts';
import {
  addressInFrame,
  addressRange,
  isSixDigits,
  openReadings,
  settled,
  withAddress,
} from '../../../../src/workbench/frame/address-typed.ts';
import { registerNamesOf } from '../../../../src/workbench/frame/device-names.ts';
import { type Draft, firstDraft } from '../../../../src/workbench/frame/draft.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';

const { addresses, meaning } = await languages.en.tools();
const { strip } = await languages.en.page();

const namesOf = (id: string) => registerNamesOf(builtInProfiles.find((profile) => profile.id === id)!);
const inFrame = (typed: string, device?: string) =>
  addressInFrame(typed, 'holding-register', { convention: 'protocol', names: device ? namesOf(device) : undefined });

describe('the text that a frame gets for an address as typed', () => {
  it('is an address that means the same to everybody, if it was the name of a register of the device', () => {
    expect(inFrame('P0683')).toBe('P0683');
    expect(inFrame('P0683', 'weg-drive')).toBe('HR684');
    expect(inFrame('p 0681', 'weg-drive')).toBe('HR682');
    expect(inFrame('VW 804', 's7-200')).toBe('HR3');
    expect(inFrame('P0683', 's7-200')).toBe('P0683');
  });

  it('is a number as it stands, also where a device has it as a name', () => {
    expect(inFrame('683', 'weg-drive')).toBe('683');
  });

  it('is counted from 0 or has its table, where the manual counts otherwise', () => {
    const manual = (typed: string, convention: Parameters<typeof addressInFrame>[2]['convention']) =>
      addressInFrame(typed, 'holding-register', { convention, names: undefined });
    expect(manual('40108', 'digits')).toBe('HR108');
    expect(manual('108', 'one-based')).toBe('HR108');
    expect(manual('0x6B', 'digits')).toBe('0x6B');
    expect(manual('108', 'protocol')).toBe('108');
  });
});

const PLAIN = { convention: 'protocol', names: undefined } as const;
const bytesOf = (draft: Draft) => Buffer.from(evaluate(draft).frame!.bytes).toString('hex').toUpperCase();
const request = (texts: Draft['texts']): Draft => ({ ...firstDraft, texts: { unitId: '17', ...texts } });
const opened = (draft: Draft, context: Parameters<typeof openReadings>[2] = PLAIN) =>
  openReadings(draft, evaluate(draft), context);

describe('a number as manuals print it', () => {
  it.each([
    ['40108', '3', 'startAddress', 'holding-register', 'HR108'],
    ['49999', '3', 'startAddress', 'holding-register', 'HR9999'],
    ['40108', '6', 'address', 'holding-register', 'HR108'],
    ['40108', '16', 'startAddress', 'holding-register', 'HR108'],
    ['40108', '22', 'referenceAddress', 'holding-register', 'HR108'],
    ['40108', '23', 'writeStartAddress', 'holding-register', 'HR108'],
    ['30009', '4', 'startAddress', 'input-register', 'IR9'],
    ['10197', '2', 'startAddress', 'discrete-input', 'DI197'],
  ] as const)(
    '%s with function %s is the number, and the address is a click away',
    (typed, functionCode, path, table, text) => {
      const draft = withAddress(request({ functionCode }), { path, typed, table }, PLAIN);
      expect(draft.texts[path]).toBe(text);
      const [open] = opened(draft);
      expect(open).toMatchObject({ path, typed, table, address: Number(typed), taken: 'number' });
      const asAddress = settled(draft, open!, 'address');
      expect(evaluate(asAddress).frame?.reading.fields[path]).toBe(Number(typed));
      expect(opened(asAddress)).toEqual([]);
      expect(opened(settled(draft, open!, 'number'))).toEqual([]);
    },
  );

  it('is the address 107 in the frame of AP 6.3', () => {
    const draft = withAddress(
      request({ functionCode: '3', quantity: '3' }),
      { path: 'startAddress', typed: '40108', table: 'holding-register' },
      PLAIN,
    );
    expect(bytesOf(draft)).toBe('1103006B00037687');
  });

  it.each<[string, Table]>([
    ['40000', 'holding-register'],
    ['0x9CAC', 'holding-register'],
    ['30009', 'holding-register'],
    ['50001', 'holding-register'],
    ['4010', 'holding-register'],
    ['00108', 'discrete-input'],
  ])('is not what %s in a field for a %s is', (typed, table) => {
    expect(addressInFrame(typed, table, PLAIN)).toBe(typed);
  });

  it('is open in an older link too, which opens the address it always did', () => {
    const draft = request({ functionCode: '3', startAddress: '40108', quantity: '3' });
    expect(evaluate(draft).frame?.reading.fields['startAddress']).toBe(40108);
    expect(opened(draft)).toMatchObject([{ taken: 'address', number: 107, address: 40108 }]);
    expect(bytesOf(settled(draft, opened(draft)[0]!, 'number'))).toBe('1103006B00037687');
  });

  it('is not open where the convention or the device decides', () => {
    const place = { path: 'startAddress', typed: '40108', table: 'holding-register' } as const;
    const draft = request({ functionCode: '3', quantity: '3' });
    const manual = { convention: 'digits', names: undefined } as const;
    expect(opened(withAddress(draft, place, manual), manual)).toEqual([]);
    const device = { convention: 'protocol', names: namesOf('modicon-984') } as const;
    const byDevice = withAddress(draft, place, device);
    expect(byDevice.texts['startAddress']).toBe('HR108');
    expect(opened(byDevice, device)).toEqual([]);
    const meter = { ...namesOf('weg-drive'), nameAt: () => 'P40108' };
    const counted = { convention: 'protocol', names: meter } as const;
    expect(withAddress(draft, place, counted).texts['startAddress']).toBe('40108');
    expect(opened(withAddress(draft, place, counted), counted)).toEqual([]);
  });
});

describe('a range of addresses', () => {
  it.each([
    ['401000–401003', 999, 4],
    ['401000-401003', 999, 4],
    ['401000~401003', 999, 4],
    ['40108..40110', 107, 3],
    ['40108 to 40110', 107, 3],
    ['0x10 – 0x1F', 16, 16],
    ['HR108-HR110', 107, 3],
    ['5-5', 5, 1],
  ])('%s is %i and %i on', (typed, address, quantity) => {
    expect(addressRange(typed, 'holding-register', PLAIN)).toEqual({ address, quantity });
  });

  it.each(['40110-40108', '-5', '5-', '40108', '1-70000', 'a-b', '5 - 6 - 7'])('%s is none', (typed) => {
    expect(addressRange(typed, 'holding-register', PLAIN)).toBeUndefined();
  });

  it('fills start and quantity, or the length of a list', () => {
    const place = { path: 'startAddress', typed: '40108..40110', table: 'holding-register' } as const;
    const reading = withAddress(request({ functionCode: '3', quantity: '1' }), place, PLAIN);
    expect(bytesOf(reading)).toBe('1103006B00037687');
    expect(reading.typed).toEqual({ startAddress: { typed: '40108..40110', text: 'HR108' } });
    const writing = withAddress(request({ functionCode: '16', registers: '10 258' }), place, PLAIN);
    expect(writing.texts['registers']).toBe('10 258 0');
  });

  it('is no address where one register is written', () => {
    const place = { path: 'address', typed: '40108..40110', table: 'holding-register' } as const;
    const { errors } = evaluate(withAddress(request({ functionCode: '6' }), place, PLAIN));
    expect(errors.get('address')).toEqual({ code: 'not-an-address', text: '40108..40110' });
  });

  it('is by the names of a device too', () => {
    const names = namesOf('weg-drive');
    const range = addressRange('P0681–P0683', 'holding-register', { convention: 'protocol', names });
    expect(range).toEqual({ address: 681, quantity: 3 });
  });
});

describe('six digits', () => {
  const typed = (text: string) =>
    withAddress(
      { ...firstDraft, texts: { ...firstDraft.texts, functionCode: '3' } },
      { path: 'startAddress', typed: text, table: 'holding-register' },
      { convention: 'protocol', names: undefined },
    );

  it.each(['401000', '401000–401003'])('are what was typed: %s', (text) => {
    expect(isSixDigits(typed(text))).toBe(true);
  });

  it.each(['41000', '999', 'HR1000', '0x401000'])('are not what was typed: %s', (text) => {
    expect(isSixDigits(typed(text))).toBe(false);
  });

  it('are said where they were typed: in the strip, at the field and in the line of the bytes', () => {
    const { reading, bytes } = evaluate(typed('401000')).frame!;
    const span = reading.spans.find(({ kind }) => kind === 'address')!;
    const said = (sixDigits: boolean) => [
      strip.note({ reading, span, named: '', sixDigits }),
      addresses.is('holding-register', 999, sixDigits),
      meaning({ reading, bytes, span, sixDigits }),
    ];
    for (const text of said(true)) expect(text).toContain('401000');
    for (const text of said(false)) expect(text).toMatch(/\b41000\b/);
  });
});
