import { describe, expect, it } from 'vitest';
import { languages } from '../../../src/words/index.ts';
import { firstDraft as draft } from '../../../src/workbench/index.ts';

const { offer, chosen } = await languages.en.read();

describe('what a text is offered as', () => {
  it('names the function, or what stands in its place', () => {
    expect(offer({ as: 'function', code: 6, part: undefined, name: 'Write Single Register', draft })).toBe(
      'as function 06 Write Single Register',
    );
    expect(offer({ as: 'function', code: 65, part: undefined, name: undefined, draft })).toBe('as function 65 (0x41)');
  });

  it('names bytes, registers and an address with its number in manuals', () => {
    expect(offer({ as: 'bytes', bytes: Uint8Array.of(6, 0xab), draft })).toBe('as bytes 06 AB');
    expect(offer({ as: 'values', registers: [1914, 17051], draft })).toBe('as 2 registers: 1914, 17051');
    const at = {
      as: 'address',
      code: 3,
      table: 'holding-register',
      sixDigits: false,
      quantity: undefined,
      value: undefined,
      unit: undefined,
      name: undefined,
      device: undefined,
      draft,
    } as const;
    expect(offer({ ...at, address: 107 })).toBe('as register 40108 (address 107)');
    expect(offer({ ...at, address: 999 })).toBe('as register 41000 (address 999)');
    expect(offer({ ...at, address: 999, sixDigits: true })).toBe('as register 401000 (address 999)');
    expect(offer({ ...at, address: 107, quantity: '3', unit: '17' })).toBe(
      'as 3 from register 40108 (address 107), unit 17',
    );
    expect(offer({ ...at, address: 683, name: 'P0683', device: 'WEG drive' })).toBe(
      'as P0683 of WEG drive: register 40684 (address 683)',
    );
    expect(offer({ ...at, address: 683, value: '45 Hz', name: 'P0683', device: 'WEG drive' })).toBe(
      'as 45 Hz written to P0683 of WEG drive: register 40684 (address 683)',
    );
  });

  it('names a number with its type, and the order of its words where it has several', () => {
    const number = { as: 'number', draft } as const;
    expect(offer({ ...number, number: '-5', type: 'i16', order: 'ABCD', registers: [0xfffb] })).toBe(
      'as i16 -5: 0xFFFB',
    );
    expect(offer({ ...number, number: '77.5', type: 'f32', order: 'CDAB', registers: [0, 0x429b] })).toBe(
      'as f32 CDAB 77.5: 0x0000 0x429B',
    );
    expect(offer({ as: 'unit', unit: '17', draft })).toBe('as unit 17');
  });
});

describe('a device that a name in the text chose', () => {
  it('is said with its line, where that came with it', () => {
    const line = { baud: 9600, dataBits: 8, parity: 'none', stopBits: 1 } as const;
    expect(chosen('WEG drive', line)).toBe('WEG drive was chosen, with its line 9600 8N1.');
    expect(chosen('S7-200', undefined)).toBe('S7-200 was chosen.');
  });
});
