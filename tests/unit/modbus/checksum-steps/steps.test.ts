import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  CrcSteps,
  checkPrinted,
  crcCatalogue,
  LrcSteps,
  lrc,
  receiverCheck,
  residueOf,
  sentBytes,
  twoTableStep,
  twoTables,
  wegExample,
} from '../../../../src/modbus/index.ts';
import { hex } from '../frames.ts';

const named = (wanted: string) => crcCatalogue.find(({ name }) => name === wanted)!;
const modbus = named('CRC-16/MODBUS');
const rows = crcCatalogue.map((row) => [row.name, row] as const);
const anyBytes = fc.uint8Array({ maxLength: 30 });

describe('the two tables', () => {
  const steps = new CrcSteps(modbus, hex('02 07'));
  const tables = twoTables(steps)!;

  it('begin and end as auchCRCHi and auchCRCLo (SL 6.2.2)', () => {
    expect(tables.first.subarray(0, 32)).toEqual(
      hex('00 C1 81 40 01 C0 80 41 01 C0 80 41 00 C1 81 40 01 C0 80 41 00 C1 81 40 00 C1 81 40 01 C0 80 41'),
    );
    expect(tables.second.subarray(0, 32)).toEqual(
      hex('00 C0 C1 01 C3 03 02 C2 C6 06 07 C7 05 C5 C4 04 CC 0C 0D CD 0F CF CE 0E 0A CA CB 0B C9 09 08 C8'),
    );
    expect(tables.first.subarray(240)).toEqual(hex('00 C1 81 40 01 C0 80 41 01 C0 80 41 00 C1 81 40'));
    expect(tables.second.subarray(240)).toEqual(hex('44 84 85 45 87 47 46 86 82 42 43 83 41 81 80 40'));
  });

  it('take the bytes of the example to 41 12', () => {
    expect(twoTableStep(tables, steps, 0)).toEqual({
      before: { first: 0xff, second: 0xff },
      index: 0xfd,
      // 81C1 is the entry of FD: FF xor C1, and 81.
      after: { first: 0x3e, second: 0x81 },
    });
    expect(twoTableStep(tables, steps, 1)).toEqual({
      before: { first: 0x3e, second: 0x81 },
      index: 0x39,
      after: { first: 0x41, second: 0x12 },
    });
  });

  it.each(rows.filter(([, { width }]) => width === 16))('%s: the halves go where the register goes', (_, row) => {
    fc.assert(
      fc.property(fc.uint8Array({ minLength: 1, maxLength: 20 }), (bytes) => {
        const these = new CrcSteps(row, bytes);
        const step = twoTableStep(twoTables(these)!, these, bytes.length - 1);
        const { first, second } = step.after;
        expect(row.refin ? (second << 8) | first : (first << 8) | second).toBe(these.last);
      }),
      { numRuns: 20 },
    );
  });

  it('are of 16 bits only', () => {
    expect(twoTables(new CrcSteps(named('CRC-32/ISO-HDLC'), hex('00')))).toBeUndefined();
    expect(twoTables(new CrcSteps(named('CRC-8/SMBUS'), hex('00')))).toBeUndefined();
  });
});

describe('the receiver', () => {
  it('has nothing left of 02 07 41 12, and something of 02 07 12 41', () => {
    const { sent, steps, residue, swapped } = receiverCheck(modbus, hex('02 07'))!;
    expect(sent).toEqual(hex('41 12'));
    expect(steps.map(({ value, before, after }) => [value, before, after])).toEqual([
      [0x41, 0x1241, 0x0012],
      [0x12, 0x0012, 0x0000],
    ]);
    expect(residue).toBe(0);
    expect(swapped).toBe(0xcd7c);
  });

  it.each(rows)('%s: what is left is the residue of the catalogue, whatever was sent', (_, row) => {
    expect(residueOf(row)).toBe(row.residue);
    fc.assert(
      fc.property(anyBytes, (bytes) => receiverCheck(row, bytes)!.residue === row.residue),
      { numRuns: 10 },
    );
  });

  it('needs whole bytes, and a value that is not turned round', () => {
    const umts = { width: 12, poly: 0x80f, init: 0, refin: false, refout: true, xorout: 0 };
    const usb = { width: 5, poly: 0x05, init: 0x1f, refin: true, refout: true, xorout: 0x1f };
    const turned = { ...modbus, refout: false };
    for (const row of [umts, usb, turned]) {
      expect(sentBytes(row, 1)).toBeUndefined();
      expect(receiverCheck(row, hex('00'))).toBeUndefined();
    }
  });

  it('gets the high byte first where the register moves to the left', () => {
    expect(sentBytes(named('CRC-16/XMODEM'), 0x31c3)).toEqual(hex('31 C3'));
    expect(sentBytes(named('CRC-32/ISO-HDLC'), 0xcbf43926)).toEqual(hex('26 39 F4 CB'));
  });
});

describe('the LRC', () => {
  it('is what brings the sum of 0A 01 04 A1 00 01 to zero', () => {
    const steps = new LrcSteps(hex('0A 01 04 A1 00 01'));
    expect([...steps.sums]).toEqual([0x00, 0x0a, 0x0b, 0x0f, 0xb0, 0xb0, 0xb1]);
    expect(steps.inverted).toBe(0x4e);
    expect(steps.value).toBe(0x4f);
  });

  it('is that of the encoder', () => {
    fc.assert(fc.property(anyBytes, (bytes) => new LrcSteps(bytes).value === lrc(bytes)));
  });

  it('is 0 for a sum of 0', () => {
    expect(new LrcSteps(hex('80 80')).value).toBe(0);
  });
});

describe('the printed example of the guide', () => {
  const verdicts = checkPrinted(modbus, wegExample);

  it('is wrong from its first line', () => {
    expect(verdicts.map(({ kind }) => kind)).toEqual([
      'wrong', // FFF9 shifted and xored is DFFD
      'follows', // D7FC ends in 0
      'follows', // 6BFE ends in 0
      'wrong', // 35FF shifted and xored is BAFE
      'wrong', // CAFF: C57E
      'wrong', // B57F: FABE
      'wrong', // FABF: DD5E
      'wrong', // DD5F: CEAE
    ]);
    expect(verdicts.map(({ byRule }) => byRule.after)).toEqual([
      0xdffd, 0x6bfe, 0x35ff, 0xbafe, 0xc57e, 0xfabe, 0xdd5e, 0xceae,
    ]);
    expect(verdicts.map(({ right }) => right.after)).toEqual([
      0xdffd, 0xcfff, 0xc7fe, 0x63ff, 0x91fe, 0x48ff, 0x847e, 0x423f,
    ]);
  });

  it('would be right with the right registers', () => {
    const shifts = [0xdffd, 0xcfff, 0xc7fe, 0x63ff, 0x91fe, 0x48ff, 0x847e, 0x423f];
    const outs = [1, 1, 1, 0, 1, 0, 1, 0] as const;
    const right = { ...wegExample, shifts: shifts.map((after, i) => ({ out: outs[i]!, after })) };
    expect(checkPrinted(modbus, right).map(({ kind }) => kind)).toEqual(Array(8).fill('right'));
  });
});
