import { describe, expect, test } from 'vitest';
import { mbpollCommand, ncCommand } from '../../../src/bus/index.ts';
import { decodeFrame } from '../../../src/modbus/index.ts';
import { hex } from '../modbus/frames.ts';

const command = (frame: string) =>
  mbpollCommand(decodeFrame(hex(frame), { transport: 'tcp', direction: 'request' }), 'plc.local');

describe('mbpoll', () => {
  test.each([
    ['coils', '0001 0000 0006 11 01 0013 0025', '-a 17 -t 0 -r 19 -c 37 plc.local'],
    ['inputs', '0001 0000 0006 11 02 00C4 0016', '-a 17 -t 1 -r 196 -c 22 plc.local'],
    ['holding registers', '0001 0000 0006 11 03 006B 0003', '-a 17 -t 4 -r 107 -c 3 plc.local'],
    ['input registers', '0001 0000 0006 11 04 0008 0001', '-a 17 -t 3 -r 8 -c 1 plc.local'],
    ['a coil on', '0001 0000 0006 11 05 00AC FF00', '-a 17 -t 0 -r 172 plc.local -- 1'],
    ['a coil off', '0001 0000 0006 11 05 00AC 0000', '-a 17 -t 0 -r 172 plc.local -- 0'],
    ['a register', '0001 0000 0006 11 06 0001 0003', '-a 17 -t 4 -r 1 plc.local -- 3'],
    ['coils written', '0001 0000 0008 11 0F 0013 0004 01 0D', '-a 17 -t 0 -r 19 -W plc.local -- 1 0 1 1'],
    ['one register by 10', '0001 0000 0009 11 10 0001 0001 02 000A', '-a 17 -t 4 -r 1 -W plc.local -- 10'],
    ['registers', '0001 0000 000B 11 10 0001 0002 04 000A 0102', '-a 17 -t 4 -r 1 -W plc.local -- 10 258'],
  ])('does it: %s', (_, frame, options) => {
    expect(command(frame)).toBe(`mbpoll -m tcp -0 -1 ${options}`);
  });

  test.each([
    ['a coil neither on nor off', '0001 0000 0006 11 05 00AC 1234'],
    ['mask', '0001 0000 0008 11 16 0004 00F2 0025'],
    ['server ID', '0001 0000 0002 11 11'],
    ['cut off', '0001 0000 0006 11 03'],
    ['nothing', ''],
  ])('cannot do it: %s', (_, frame) => {
    expect(command(frame)).toBeUndefined();
  });
});

test('nc sends the bytes as they are', () => {
  expect(ncCommand(hex('0001 0000 0006 11 03 006B 0003'), '192.168.0.10', 502)).toBe(
    "printf '\\000\\001\\000\\000\\000\\006\\021\\003\\000\\153\\000\\003' | nc -w 2 192.168.0.10 502 | xxd",
  );
});
