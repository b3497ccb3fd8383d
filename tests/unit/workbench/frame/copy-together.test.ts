import { expect, it } from 'vitest';
import { decodeFrame, fromHex } from '../../../../src/modbus/index.ts';
import { copyTogether } from '../../../../src/workbench/index.ts';

const frame = (name: string, hex: string) => {
  const bytes = fromHex(hex)!;
  return { name, bytes, reading: decodeFrame(bytes, { transport: 'rtu', direction: 'request' }) };
};
/** The frames that the WEG guide sends to its drive. */
const SET = '060602AB1000F5E5';
const RUN = '060602AA00016825';

const copied = (format: 'c' | 'st' | 'spaced' | 'csharp', frames: ReturnType<typeof frame>[]) =>
  copyTogether(frames, { format, checksum: true }).split('\n');
const names = (format: 'c' | 'st' | 'csharp', frames: ReturnType<typeof frame>[]) =>
  copied(format, frames).map((line) => line.match(/\w+(?=\[\d| : ARRAY| = \{)/)?.[0]);

it('copies each frame on a line of its own, under its name', () => {
  const frames = [frame('Set 30 Hz', SET), frame('Start the drive', RUN)];
  expect(copied('c', frames)).toEqual([
    'const uint8_t set_30_hz[8] = { 0x06, 0x06, 0x02, 0xAB, 0x10, 0x00, 0xF5, 0xE5 };',
    'const uint8_t start_the_drive[8] = { 0x06, 0x06, 0x02, 0xAA, 0x00, 0x01, 0x68, 0x25 };',
  ]);
  expect(copied('st', frames)).toEqual([
    'Set30Hz : ARRAY[0..7] OF BYTE := [16#06, 16#06, 16#02, 16#AB, 16#10, 16#00, 16#F5, 16#E5];',
    'StartTheDrive : ARRAY[0..7] OF BYTE := [16#06, 16#06, 16#02, 16#AA, 16#00, 16#01, 16#68, 16#25];',
  ]);
  expect(copied('spaced', frames)).toEqual(['06 06 02 AB 10 00 F5 E5', '06 06 02 AA 00 01 68 25']);
});

it('gives no name twice, also where only capitals or the ends of words tell names apart', () => {
  const given = ['Set speed', 'set  SPEED!', 'Sets peed', 'Set speed 2'].map((name) => frame(name, SET));
  for (const format of ['c', 'st'] as const) {
    const got = names(format, given).map((name) => name?.toLowerCase().replaceAll('_', ''));
    expect(new Set(got).size, format).toBe(4);
  }
});

it('gives no name that a language refuses: a digit first, a word of its own, letters that it does not take', () => {
  expect(names('c', [frame('30 Hz', SET), frame('for', SET), frame('Größe é', SET), frame('速度', SET)])).toEqual([
    'frame_30_hz',
    'frame_for',
    'groesse_e',
    'write_683_4096',
  ]);
  expect(names('c', [frame('Überdruck ÄÖ Œuvre', SET)])).toEqual(['ueberdruck_aeoe_oeuvre']);
  expect(names('csharp', [frame('new', SET), frame('速度', SET), frame('速度 2', SET)])).toEqual([
    'frameNew',
    'write683_4096',
    'frame2',
  ]);
});
