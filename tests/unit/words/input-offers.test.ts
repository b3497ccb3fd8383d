import { describe, expect, it } from 'vitest';
import { languages } from '../../../src/words/index.ts';
import { firstDraft as draft } from '../../../src/workbench/index.ts';

const { offer } = await languages.en.read();

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
    expect(
      offer({ as: 'address', table: 'holding-register', address: 107, name: undefined, device: undefined, draft }),
    ).toBe('as register 40108 (address 107)');
    expect(
      offer({ as: 'address', table: 'holding-register', address: 683, name: 'P0683', device: 'WEG drive', draft }),
    ).toBe('as P0683 of WEG drive: register 40684 (address 683)');
  });
});
