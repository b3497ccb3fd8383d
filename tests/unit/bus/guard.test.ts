import { describe, expect, test } from 'vitest';
import { mayChange, permissionFor } from '../../../src/bus/index.ts';
import { decodeFrame } from '../../../src/modbus/index.ts';
import { hex } from '../modbus/frames.ts';

const request = (frame: string) => decodeFrame(hex(frame), { transport: 'rtu', direction: 'request' });

const READS = [
  ['01 coils', '11 01 00 13 00 25 0E 84'],
  ['02 discrete inputs', '11 02 00 C4 00 16 BA A9'],
  ['03 holding registers', '11 03 00 6B 00 03 76 87'],
  ['04 input registers', '11 04 00 08 00 01 B2 98'],
  ['07 exception status', '11 07 4C 22'],
  ['08 00 query data', '11 08 00 00 A5 37 D8 1D'],
  ['08 02 diagnostic register', '11 08 00 02 00 00 43 5B'],
  ['08 0B message count', '11 08 00 0B 00 00 93 59'],
  ['0B event counter', '11 0B 4C 27'],
  ['0C event log', '11 0C 0D E5'],
  ['11 server ID', '11 11 CD EC'],
  ['14 file record', '11 14 07 06 00 04 00 01 00 02 D9 70'],
  ['18 FIFO queue', '11 18 04 DE 07 87'],
  ['2B 0E identification', '11 2B 0E 01 00 B1 B4'],
] as const;

const CHANGES = [
  ['05 coil', '11 05 00 AC FF 00 4E 8B'],
  ['06 register', '11 06 00 01 00 03 9A 9B'],
  ['08 01 restart', '11 08 00 01 00 00 B3 5B'],
  ['08 03 delimiter', '11 08 00 03 0A 00 14 3B'],
  ['08 04 listen only', '11 08 00 04 00 00 A3 5A'],
  ['08 0A clear counters', '11 08 00 0A 00 00 C2 99'],
  ['08 14 clear overrun counter', '11 08 00 14 00 00 A2 9F'],
  ['0F coils', '11 0F 00 13 00 0A 02 CD 01 BF 0B'],
  ['10 registers', '11 10 00 01 00 02 04 00 0A 01 02 C6 F0'],
  ['15 file record', '11 15 09 06 00 04 00 07 00 01 06 AF 04 A1'],
  ['16 mask', '11 16 00 04 00 F2 00 25 66 E2'],
  ['17 reads and writes', '11 17 00 03 00 06 00 0E 00 01 02 00 FF 9A B9'],
  ['2B 0D CANopen', '11 2B 0D 00 71 80'],
  ['41 of the user', '11 41 01 D0 55'],
  ['5A of a maker', '11 5A 00 20 24 D3'],
] as const;

const nothing: ReadonlySet<number> = new Set();

describe('what only reads is free', () => {
  test.each(READS)('%s', (_, frame) => {
    expect(mayChange(request(frame))).toBe(false);
    expect(permissionFor(request(frame), { readOnly: true, writable: nothing })).toEqual({ kind: 'free' });
  });
});

describe('what may change something is refused while read only, and else asked for once', () => {
  test.each(CHANGES)('%s', (_, frame) => {
    expect(mayChange(request(frame))).toBe(true);
    expect(permissionFor(request(frame), { readOnly: true, writable: new Set([0x11]) })).toEqual({
      kind: 'refused',
      why: 'read-only',
    });
    const permission = permissionFor(request(frame), { readOnly: false, writable: nothing });
    expect(permission.kind).toBe('ask');
  });

  test('of a unit that may be written to, and of no other', () => {
    const guard = { readOnly: false, writable: new Set([0x11]) };
    expect(permissionFor(request('11 06 00 01 00 03 9A 9B'), guard)).toEqual({ kind: 'free' });
    expect(permissionFor(request('12 06 00 01 00 03 9A A8'), guard)).toEqual({
      kind: 'ask',
      why: 'first-write',
      once: true,
    });
  });
});

test('what is only advised against is asked for as any other', () => {
  // 248 is a reserved address (SL 2.2).
  const guard = { readOnly: false, writable: nothing };
  expect(permissionFor(request('F8 03 00 6B 00 03 60 7E'), guard)).toEqual({ kind: 'free' });
  expect(permissionFor(request('F8 06 00 01 00 03 8C 62'), guard)).toEqual({
    kind: 'ask',
    why: 'first-write',
    once: true,
  });
});

describe('asked for each time', () => {
  const guard = { readOnly: false, writable: new Set([0, 0x11]) };

  test('a broadcast that writes', () => {
    expect(permissionFor(request('00 06 00 01 00 03 99 DA'), guard)).toEqual({
      kind: 'ask',
      why: 'broadcast',
      once: false,
    });
  });

  test.each([
    ['126 registers, one too many', '11 03 00 6B 00 7E B6 A6'],
    ['a wrong CRC', '11 03 00 6B 00 03 76 88'],
    ['cut off', '11 03 00 6B'],
    ['two bytes too long', '11 03 00 6B 00 03 76 87 00 00'],
    ['nothing at all', ''],
  ])('%s', (_, frame) => {
    const { kind } = permissionFor(request(frame), guard);
    expect(kind).toBe('ask');
    expect(permissionFor(request(frame), guard)).toEqual({ kind: 'ask', why: 'breaks-rule', once: false });
  });

  test.each([...READS, ...CHANGES])('%s, too short by any number of bytes, or too long', (_, frame) => {
    const whole = hex(frame);
    const cut = Array.from(whole, (_byte, length) => whole.subarray(0, length));
    // A zero behind a CRC has a right CRC again.
    for (const bytes of [...cut, Uint8Array.of(...whole, 1)]) {
      const reading = decodeFrame(bytes, { transport: 'rtu', direction: 'request' });
      expect(permissionFor(reading, guard)).toEqual({ kind: 'ask', why: 'breaks-rule', once: false });
    }
  });

  test('but while read only, what has no function code is refused', () => {
    expect(permissionFor(request(''), { ...guard, readOnly: true })).toEqual({ kind: 'refused', why: 'read-only' });
  });
});
