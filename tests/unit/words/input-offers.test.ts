import { describe, expect, it } from 'vitest';
import { languages } from '../../../src/words/index.ts';
import { firstDraft as draft } from '../../../src/workbench/index.ts';

const { offer, chosen, asked, advice } = await languages.en.read();

/** An address in holding registers, with nothing else known of it. */
const at = {
  as: 'address',
  code: 3,
  table: 'holding-register',
  address: 100,
  sixDigits: false,
  quantity: undefined,
  value: undefined,
  unit: undefined,
  name: undefined,
  device: undefined,
  draft,
} as const;

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

  it('names the bit, the controller, and the function of a value whose type was not typed', () => {
    expect(offer({ ...at, bit: 5 })).toBe('as bit 5 of register 40101 (address 100), whose other bits are read too');
    expect(offer({ ...at, bit: 5, code: 22, value: 'on' })).toBe(
      'as on written to bit 5 of register 40101 (address 100), by function 22 (0x16)',
    );
    expect(offer({ ...at, plc: 'omron' })).toBe('as register 40101 = address 100 = 0x0064, in an Omron controller');
    expect(offer({ ...at, code: 16, value: 'f32 CDAB 77.5', isWide: true, unit: '17' })).toBe(
      'as f32 CDAB 77.5 written to register 40101 (address 100), by function 16 (0x10), unit 17',
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

describe('what a text asks of another view', () => {
  it('is answered', () => {
    const crc = { tool: 'checksum', size: 2, parts: {} } as const;
    expect(asked.checksum({ ...crc, crc: 0x1241 })).toBe('Over 2 bytes: CRC 0x1241, sent as 41 12.');
    expect(asked.checksum({ ...crc, crc: 0x1241, lrc: 0xf7 })).toBe(
      'Over 2 bytes: CRC 0x1241, sent as 41 12; LRC 0xF7.',
    );
    expect(asked.checksum(crc)).toContain('Modbus has no such checksum');
    expect(asked.checksum({ ...crc, size: 0 })).toBe('Type the bytes behind it, such as “crc 02 07”.');
    const line = { baud: 9600, dataBits: 8, parity: 'none', stopBits: 1 } as const;
    // SL 2.5.1.1: one and a half and three and a half characters of ten bits.
    const timing = { tool: 'timing', line, character: 1041.6667, t15: 1562.5, t35: 3645.8333, parts: {} } as const;
    expect(asked.timing(timing)).toBe('At 9600 8N1 a character takes 1.042 ms; t1.5 is 1.563 ms, t3.5 is 3.646 ms.');
    expect(asked.timing({ ...timing, wrong: '30' })).toContain('50 to 4,000,000 baud');
    expect(asked.exception(2)).toMatch(/^Exception 02, ILLEGAL DATA ADDRESS: ./);
    expect(asked.exception(0x63)).toBe('Exception 63 is not in the specification.');
  });

  it('is told what would do where it means nothing', () => {
    expect(advice({ code: 'name-unknown', name: 'W100' })).toContain('40108, 4x108, HR108');
    expect(advice({ code: 'read-only', table: 'input-register' })).toContain('Nothing writes input registers');
  });
});
