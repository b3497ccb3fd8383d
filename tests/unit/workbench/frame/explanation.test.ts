import { describe, expect, it } from 'vitest';
import { builtInProfiles, type Profile, plainRegister } from '../../../../src/devices/index.ts';
import { devices } from '../../../../src/words/en/devices.ts';
import { languages } from '../../../../src/words/index.ts';
import { frameNames } from '../../../../src/workbench/devices/frame-names.ts';
import { evaluate } from '../../../../src/workbench/frame/evaluate.ts';
import { explain, linesOf, type Unfolded } from '../../../../src/workbench/frame/explanation.ts';
import { explanationText } from '../../../../src/workbench/frame/explanation-text.ts';
import { readLink } from '../../../../src/workbench/frame/link.ts';
import { canCopyAs, copyText, hasChecksum, readCopyFormat } from '../../../../src/workbench/index.ts';
import { explanationWords } from './explanation-words.ts';

const en = await languages.en.page();

const words = await explanationWords();
const framed = (link: string) => evaluate(readLink(link)!.draft).frame!;
const rowsOf = (link: string, device?: string, unfolded: Unfolded = () => true) => {
  const frame = framed(link);
  const profile = builtInProfiles.find(({ id }) => id === device);
  return explain({ ...frame, words, names: profile && frameNames(profile, devices)(frame.reading) }, unfolded);
};

/** 06 06 02 AB 10 00 F5 E5: the drive's speed reference is 4096 of 8192. */
const SET_30_HZ = '#rtu/request?unitId=6&functionCode=6&address=0x02AB&value=4096';
const WRITE_TWO = '#rtu/request?unitId=17&functionCode=16&startAddress=107&registers=1000 2';

describe('the lines that explain a frame', () => {
  it('are one for each field, and one for each byte of what has several once it is unfolded', () => {
    expect(rowsOf(SET_30_HZ, undefined, () => false).map(({ offset, unfolded }) => [offset, unfolded])).toEqual([
      ['0', undefined],
      ['1', undefined],
      ['2–3', false],
      ['4–5', false],
      ['6–7', false],
    ]);
    const value = rowsOf(SET_30_HZ, undefined, () => false)[3]!.key;
    expect(rowsOf(SET_30_HZ, undefined, (key) => key === value).map(({ offset, depth }) => [offset, depth])).toEqual([
      ['0', 0],
      ['1', 0],
      ['2–3', 0],
      ['4–5', 0],
      ['4', 1],
      ['5', 1],
      ['6–7', 0],
    ]);
  });

  it('are a line a register: 123 of them are 130 lines', () => {
    const registers = Array.from({ length: 123 }, (_, index) => index).join('+');
    const link = `#rtu/request?unitId=17&functionCode=16&startAddress=107&registers=${registers}`;
    // Unit, function, address, quantity, byte count, the list and its 123 registers, CRC.
    expect(rowsOf(link, undefined, () => false)).toHaveLength(5 + 1 + 123 + 1);
  });

  it('are one for each byte of what has several', () => {
    expect(rowsOf(SET_30_HZ).map(({ offset, hex, decimal, label }) => [offset, hex, decimal, label])).toEqual([
      ['0', '06', '6', 'Unit (slave address)'],
      ['1', '06', '6', 'Function code'],
      ['2–3', '02 AB', '683', 'Address'],
      ['2', '02', '2', ''],
      ['3', 'AB', '171', ''],
      ['4–5', '10 00', '4096', 'Value'],
      ['4', '10', '16', ''],
      ['5', '00', '0', ''],
      ['6–7', 'F5 E5', '245 229', 'Checksum'],
      ['6', 'F5', '245', ''],
      ['7', 'E5', '229', ''],
    ]);
  });

  it('tell each register of a list, its bytes and their bits', () => {
    const rows = rowsOf(WRITE_TWO);
    const register = rows.findIndex(({ offset, depth }) => depth === 1 && offset === '7–8');
    expect(rows[register]).toMatchObject({ hex: '03 E8', decimal: '1000', bits: '' });
    expect(rows[register]?.meaning).toBe('Register 40108 (address 107) = 1000 (0x03E8).');
    expect(rows[register + 1]).toMatchObject({ hex: '03', bits: '0000 0011', meaning: 'High byte: 3 × 256 = 768.' });
    expect(rows[register + 2]).toMatchObject({ hex: 'E8', bits: '1110 1000', meaning: 'Low byte: 232.' });
  });

  it('tell each field of a group, and each byte of data', () => {
    const group = rowsOf('#rtu/request?functionCode=20&subRequests=1&subRequests[0].fileNumber=4');
    expect(group.filter(({ offset, hex }) => /^\d+$/.test(offset) && hex.length === 2)).toHaveLength(12);
    expect(group.map(({ meaning }) => meaning)).toContain('File number: 4.');
    const data = rowsOf('#rtu/reply?functionCode=17&data=01 FF 41');
    expect(data.find(({ offset, depth }) => depth === 1 && offset === '5')).toMatchObject({
      hex: '41',
      decimal: '65',
      bits: '0100 0001',
      meaning: 'As a character: A',
    });
  });

  it('show two characters of ASCII as the byte that they stand for', () => {
    const rows = rowsOf('#ascii/request?unitId=17&functionCode=3&startAddress=107&quantity=3');
    const address = rows.findIndex(({ label }) => label === 'Start address');
    expect(rows[address]).toMatchObject({ offset: '5–8', hex: '30 30 36 42', characters: '006B' });
    expect(rows[address + 2]).toMatchObject({ offset: '7–8', hex: '36 42', meaning: 'Low byte: 107.' });
  });

  it('say the number of what two or four characters of ASCII carry, not of the characters', () => {
    // :060602AB100037: the unit is 06, the address 02AB, the value 1000, the LRC 37.
    const rows = rowsOf('#ascii/request?unitId=6&functionCode=6&address=0x02AB&value=4096', undefined, () => false);
    expect(rows.map(({ characters, decimal, bits }) => [characters, decimal, bits])).toEqual([
      [':', '58', '0011 1010'],
      ['06', '6', '0000 0110'],
      ['06', '6', '0000 0110'],
      ['02AB', '683', ''],
      ['1000', '4096', ''],
      ['37', '55', '0011 0111'],
      ['CRLF', '', ''],
    ]);
  });

  it('name what a device has in them before what the specification says', () => {
    const names = rowsOf(SET_30_HZ, 'weg-drive').map(({ name }) => name);
    expect(names[2]).toBe('P0683 speed reference.');
    expect(names[5]).toBe('P0683 speed reference = 4096 (30.0 Hz).');
  });

  it('have one line for a value in two registers, which unfolds into the registers and their bytes', () => {
    // Modicon 984: 40001 is a float, 0x42C8 0x0000 is 100.
    const floats: Profile = {
      ...(builtInProfiles.find(({ id }) => id === 'modicon-984') as Profile),
      registers: [
        { ...plainRegister, table: 'holding-register', address: 107, name: 'Flow', type: 'f32', order: 'ABCD' },
      ],
    };
    const frame = framed('#rtu/reply?unitId=17&functionCode=3&registers=0x42C8+0+7&answering=1103006B000376 87');
    const lines = (unfolded: Unfolded) =>
      explain({ ...frame, words, names: frameNames(floats, devices)(frame.reading) }, unfolded);
    const folded = lines(() => false);
    expect(folded.map(({ offset, name, meaning }) => [offset, name, meaning]).slice(4, 6)).toEqual([
      ['3–6', 'Flow = 100.', 'Registers 40108–40109 (addresses 107–108).'],
      ['7–8', '', 'Register 40110 (address 109) = 7 (0x0007).'],
    ]);
    expect(
      lines((key) => key === folded[4]!.key)
        .slice(4, 8)
        .map(({ offset, depth, name, meaning }) => [offset, depth, name, meaning]),
    ).toEqual([
      ['3–6', 1, 'Flow = 100.', 'Registers 40108–40109 (addresses 107–108).'],
      ['3–4', 2, '', 'Register 40108 (address 107) = 17096 (0x42C8).'],
      ['5–6', 2, '', 'Register 40109 (address 108) = 0 (0x0000).'],
      ['7–8', 1, '', 'Register 40110 (address 109) = 7 (0x0007).'],
    ]);
  });

  it('say what is wrong in their place, and that a device has it so', () => {
    const link = '#rtu/reply?unitId=1&functionCode=3&registers=0x447A 0x2000&answering=01031B590001532D';
    const count = (device?: string) => rowsOf(link, device).find(({ label }) => label === 'Byte count')!;
    expect(count()).toMatchObject({ severity: 'error' });
    expect(count().problems).toBe('The byte count is 4, but the request asked for 2.');
    expect(count('enron-daniel').problems).toContain('For Enron, Daniel (flow computers) it is right');
  });

  it('write out of a long text no more than a legal frame could have', () => {
    const frame = framed(`#rtu/request?functionCode=99&data="${'A'.repeat(200_000)}"`);
    const lines = linesOf({ ...frame, words });
    expect(lines).toHaveLength(1 + 1 + 1 + 1);
    expect(linesOf({ ...frame, words }, () => true)).toHaveLength(1 + 1 + 1 + 200_000 + 1 + 2);
    expect(lines[2]!().meaning).toBe(`200,000 bytes of raw data, as text “${'A'.repeat(600)}…”.`);
  });
});

describe('what is copied', () => {
  const { reading, bytes } = framed(SET_30_HZ);

  it('is the frame in a format, with or without its checksum', () => {
    expect(copyText(reading, bytes, { format: 'spaced', checksum: true })).toBe('06 06 02 AB 10 00 F5 E5');
    // The LRC of 06 06 02 AB 10 00 is 37: together they sum to 0 (SL 2.5.2.2).
    expect(copyText(reading, bytes, { format: 'ascii-line', checksum: true })).toBe(':060602AB100037');
  });

  it.each([
    ['plain', '060602AB1000F5E5', '060602AB1000'],
    ['list', '0x06, 0x06, 0x02, 0xAB, 0x10, 0x00, 0xF5, 0xE5', '0x06, 0x06, 0x02, 0xAB, 0x10, 0x00'],
    [
      'c',
      'const uint8_t write_683_4096[8] = { 0x06, 0x06, 0x02, 0xAB, 0x10, 0x00, 0xF5, 0xE5 };',
      'const uint8_t write_683_4096[6] = { 0x06, 0x06, 0x02, 0xAB, 0x10, 0x00 };',
    ],
    [
      'st',
      'Write683_4096 : ARRAY[0..7] OF BYTE := [16#06, 16#06, 16#02, 16#AB, 16#10, 16#00, 16#F5, 16#E5];',
      'Write683_4096 : ARRAY[0..5] OF BYTE := [16#06, 16#06, 16#02, 16#AB, 16#10, 16#00];',
    ],
    ['brackets', '[0x06][0x06][0x02][0xAB][0x10][0x00][0xF5][0xE5]', '[0x06][0x06][0x02][0xAB][0x10][0x00]'],
    ['escapes', '\\x06\\x06\\x02\\xAB\\x10\\x00\\xF5\\xE5', '\\x06\\x06\\x02\\xAB\\x10\\x00'],
    ['decimal', '6, 6, 2, 171, 16, 0, 245, 229', '6, 6, 2, 171, 16, 0'],
  ] as const)('is the frame as %s', (format, whole, without) => {
    expect(copyText(reading, bytes, { format, checksum: true })).toBe(whole);
    expect(copyText(reading, bytes, { format, checksum: false })).toBe(without);
  });

  it('is no ASCII line, if the frame has no unit for it', () => {
    const pdu = framed('#pdu/request?functionCode=6&address=0&value=1');
    expect(canCopyAs(pdu.reading, 'ascii-line')).toBe(false);
    expect(copyText(pdu.reading, pdu.bytes, { format: 'ascii-line', checksum: true })).toBeUndefined();
    expect(hasChecksum(pdu.reading)).toBe(false);
    expect(copyText(pdu.reading, pdu.bytes, { format: 'spaced', checksum: false })).toBe('06 00 00 00 01');
  });

  it('is the explanation as a table, a row for each line', () => {
    const text = (as: 'markdown' | 'table') =>
      explanationText({ reading, bytes, words }, en.page.columns, as).split('\n');
    expect(text('table')[0]).toBe('byte\thex\tdec.\tbits\tmeans\tsection');
    expect(text('table')[3]).toMatch(
      /^2–3\t02 AB\t683\t\tAddress\. Address 683 \(0x02AB\) = register 40684\. .*\t§6\.6$/,
    );
    expect(text('markdown')[1]).toMatch(/^\|[ |-]+\|$/);
    expect(text('markdown').filter((line) => line !== '')).toHaveLength(2 + 5);
  });

  it('is remembered as a format that there is', () => {
    expect(readCopyFormat('c')).toBe('c');
    // As it was stored with the checksum.
    expect(readCopyFormat({ format: 'st', checksum: false })).toBe('st');
    for (const value of [null, 7, {}, 'toString', { format: 'toString', checksum: true }]) {
      expect(readCopyFormat(value)).toBeUndefined();
    }
  });
});
