import { describe, expect, test } from 'vitest';
import { decodeFrame, fromHex, readSerialFormat } from '../../../../src/modbus/index.ts';
import { receiverFor, receiverKinds, receiverLine, receptionOf } from '../../../../src/workbench/wire/receivers.ts';
import { receivedOf, sceneOf } from '../../../../src/workbench/wire/scene.ts';

const bytes = fromHex('0103006B00037417')!;
const sender = { baud: 19_200, ...readSerialFormat('8E1')! };
const own = { baud: 9600, ...readSerialFormat('7O2')! };
const scene = sceneOf(
  [{ bytes, reading: decodeFrame(bytes, { transport: 'rtu', direction: 'request' }), current: true }],
  { serial: sender, delay: 0, gap: undefined },
);
const received = (kind: (typeof receiverKinds)[number]) => {
  const line = receiverLine(kind, sender, own)!;
  return receivedOf(scene, receiverFor(kind, sender, line));
};

describe('a receiver set otherwise', () => {
  test('differs in the one thing that its kind names', () => {
    const lines = receiverKinds.map((kind) => receiverLine(kind, sender, own));
    expect(lines).toEqual([
      undefined,
      { ...sender, parity: 'odd' },
      { ...sender, parity: 'none' },
      { ...sender, dataBits: 7 },
      { ...sender, baud: 38_400 },
      { ...sender, baud: 9600 },
      sender,
      own,
    ]);
    expect(receiverLine('parity', { ...sender, parity: 'none' }, own)?.parity).toBe('even');
    expect(receiverLine('data-bits', own, own)?.dataBits).toBe(8);
  });

  test('counts in the bit times of the sender, and upside down only if its wires are swapped', () => {
    expect(receiverFor('double', sender, { ...sender, baud: 38_400 })).toMatchObject({ bit: 0.5, inverted: false });
    expect(receiverFor('half', sender, { ...sender, baud: 9600 }).bit).toBe(2);
    expect(receiverFor('swapped', sender, sender)).toMatchObject({ bit: 1, inverted: true });
  });

  test('of another parity finds it wrong in every byte', () => {
    expect(receptionOf(bytes, received('parity'))).toEqual({ sent: 8, received: 8, wrong: 8, same: false });
  });

  test('without parity takes the parity bit for a stop bit, which is right where it is 1', () => {
    // 01 and 6B have an odd number of ones, so that their parity bit is 1.
    expect(received('no-parity').map(({ value, errors }) => [value, ...errors])).toEqual([
      [0x01],
      [0x03, 'framing'],
      [0x00, 'break'],
      [0x6b],
      [0x00, 'break'],
      [0x03, 'framing'],
      [0x74, 'framing'],
      [0x17, 'framing'],
    ]);
  });
});

describe('a reception', () => {
  const fine = (...values: number[]) => values.map((value) => ({ value, errors: [], start: 0, end: 10 }));

  test('is the same only if all bytes are, without an error', () => {
    const sent = Uint8Array.of(1, 2);
    expect(receptionOf(sent, fine(1, 2))).toEqual({ sent: 2, received: 2, wrong: 0, same: true });
    expect(receptionOf(sent, fine(1, 3))).toEqual({ sent: 2, received: 2, wrong: 0, same: false });
    expect(receptionOf(sent, fine(1))).toEqual({ sent: 2, received: 1, wrong: 0, same: false });
    expect(receptionOf(sent, [...fine(1), { value: 2, errors: ['parity'], start: 10, end: 20 }])).toEqual({
      sent: 2,
      received: 2,
      wrong: 1,
      same: false,
    });
  });
});
