import { describe, expect, it } from 'vitest';
import { CrcSteps, crcCatalogue } from '../../../../src/modbus/index.ts';
import { languages } from '../../../../src/words/index.ts';
import { binaryWidth, byteHex, registerHex } from '../../../../src/workbench/checksum/register-text.ts';
import { StepRows } from '../../../../src/workbench/checksum/step-rows.ts';
import { stepsText, stepText } from '../../../../src/workbench/checksum/steps-text.ts';
import { hex } from '../../modbus/frames.ts';

const words = await languages.en.checksumSteps();
const modbus = crcCatalogue.find(({ name }) => name === 'CRC-16/MODBUS')!;
/** The example of SL 6.2.2, whose CRC is 0x1241. */
const steps = new CrcSteps(modbus, hex('02 07'));

describe('the steps of a CRC as text', () => {
  it('are a line a row, with tabs between the columns', () => {
    expect(stepsText(steps, new StepRows(2, (at) => at === 1), words).split('\n')).toEqual([
      'Step\tRegister before\t\tOut\tXor\tRegister after\t',
      'Byte 0 0x02\t0xFFFF\t1111 1111 1111 1111\t\txor 0x02 = 0xFFFD\t0x813E\t1000 0001 0011 1110',
      'Byte 1 0x07\t0x813E\t1000 0001 0011 1110\t\txor 0x07 = 0x8139\t0x1241\t0001 0010 0100 0001',
      'shift 1\t0x8139\t1000 0001 0011 1001\t1\txor 0xA001\t0xE09D\t1110 0000 1001 1101',
      'shift 2\t0xE09D\t1110 0000 1001 1101\t1\txor 0xA001\t0xD04F\t1101 0000 0100 1111',
      'shift 3\t0xD04F\t1101 0000 0100 1111\t1\txor 0xA001\t0xC826\t1100 1000 0010 0110',
      'shift 4\t0xC826\t1100 1000 0010 0110\t0\tno xor\t0x6413\t0110 0100 0001 0011',
      'shift 5\t0x6413\t0110 0100 0001 0011\t1\txor 0xA001\t0x9208\t1001 0010 0000 1000',
      'shift 6\t0x9208\t1001 0010 0000 1000\t0\tno xor\t0x4904\t0100 1001 0000 0100',
      'shift 7\t0x4904\t0100 1001 0000 0100\t0\tno xor\t0x2482\t0010 0100 1000 0010',
      'shift 8\t0x2482\t0010 0100 1000 0010\t0\tno xor\t0x1241\t0001 0010 0100 0001',
    ]);
  });

  it('say what happens in a row', () => {
    const said = (at: number, shift: number) => stepText(steps, { at, shift }, words);
    expect(said(0, 0)).toBe('Byte 0: 0xFFFF xor 0x02 is 0xFFFD. Eight shifts make it 0x813E.');
    expect(said(0, 1)).toBe('Shift 1 of byte 0: a 1 leaves. 0x7FFE xor 0xA001 is 0xDFFF.');
    expect(said(0, 3)).toBe('Shift 3 of byte 0: a 0 leaves. The register is 0x67FF.');
    expect(said(1, 8)).toBe('Shift 8 of byte 1: a 0 leaves. The register is 0x1241.');
  });

  it('have registers with all their digits', () => {
    expect([registerHex(16, 0x12), registerHex(5, 3), byteHex(7)]).toEqual(['0x0012', '0x03', '0x07']);
    // 1111 1111 1111 1111, and 1 1111.
    expect([binaryWidth(16), binaryWidth(5)]).toEqual([19, 6]);
  });
});
