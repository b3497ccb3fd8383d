import { describe, expect, test } from 'vitest';
import type { Direction } from '../../../../src/modbus/index.ts';
import { readPdu, said, word, zeros } from '../frames.ts';

interface Quantity {
  readonly what: string;
  readonly direction: Direction;
  readonly section: string;
  readonly least: number;
  readonly most: number;
  /** The PDU that asks for `quantity` from `address`. */
  readonly pdu: (address: number, quantity: number) => number[];
}

const bytesOfBits = (bits: number) => Math.floor((bits + 7) / 8);

const quantities: readonly Quantity[] = [
  ...([0x01, 0x02] as const).map((code) => ({
    what: `${code} reads bits`,
    direction: 'request' as const,
    section: `AP 6.${code}`,
    least: 1,
    most: 2000,
    pdu: (address: number, quantity: number) => [code, ...word(address), ...word(quantity)],
  })),
  ...([0x03, 0x04] as const).map((code) => ({
    what: `${code} reads registers`,
    direction: 'request' as const,
    section: `AP 6.${code}`,
    least: 1,
    most: 125,
    pdu: (address: number, quantity: number) => [code, ...word(address), ...word(quantity)],
  })),
  {
    what: '0F writes coils',
    direction: 'request',
    section: 'AP 6.11',
    least: 1,
    most: 1968,
    pdu: (address, quantity) => {
      const bytes = bytesOfBits(quantity);
      return [0x0f, ...word(address), ...word(quantity), bytes, ...zeros(bytes)];
    },
  },
  {
    what: '0F has written coils',
    direction: 'response',
    section: 'AP 6.11',
    least: 1,
    most: 1968,
    pdu: (address, quantity) => [0x0f, ...word(address), ...word(quantity)],
  },
  {
    what: '10 writes registers',
    direction: 'request',
    section: 'AP 6.12',
    least: 1,
    most: 123,
    pdu: (address, quantity) => [0x10, ...word(address), ...word(quantity), 2 * quantity, ...zeros(2 * quantity)],
  },
  {
    what: '10 has written registers',
    direction: 'response',
    section: 'AP 6.12',
    least: 1,
    most: 123,
    pdu: (address, quantity) => [0x10, ...word(address), ...word(quantity)],
  },
  {
    what: '17 reads registers',
    direction: 'request',
    section: 'AP 6.17',
    least: 1,
    most: 125,
    pdu: (address, quantity) => [0x17, ...word(address), ...word(quantity), ...word(0), ...word(1), 2, 0, 0],
  },
  {
    what: '17 writes registers',
    direction: 'request',
    section: 'AP 6.17',
    least: 1,
    most: 121,
    pdu: (address, quantity) => {
      const written = [...word(quantity), 2 * quantity, ...zeros(2 * quantity)];
      return [0x17, ...word(0), ...word(1), ...word(address), ...written];
    },
  },
];

describe.each(quantities)('$what ($direction): $least to $most', ({ direction, section, least, most, pdu }) => {
  const faults = (address: number, quantity: number) =>
    readPdu(direction, pdu(address, quantity)).problems.filter(({ severity }) => severity !== 'note');

  test.each([least, least + 1, most - 1, most])('%i is legal', (quantity) => {
    expect(faults(0, quantity)).toEqual([]);
  });

  test.each([least - 1, most + 1])('%i is an error', (got) => {
    expect(faults(0, got)).toContainEqual(
      expect.objectContaining({ code: 'quantity-out-of-range', severity: 'error', got, least, most, section }),
    );
  });

  test('the last element is the one at 65535 (AP 4.4)', () => {
    expect(faults(65536 - most, most)).toEqual([]);
    expect(faults(65535, 1)).toEqual([]);
    expect(faults(65535, 2)).toEqual([
      expect.objectContaining({ code: 'address-range-over-end', severity: 'error', address: 65535, quantity: 2 }),
    ]);
    expect(faults(65537 - most, most)).toMatchObject([{ code: 'address-range-over-end', section: 'AP 4.4' }]);
  });
});

describe('old controllers stop earlier (PI App. B), which is worth a note', () => {
  const coils = (quantity: number) => {
    const bytes = bytesOfBits(quantity);
    return said(readPdu('request', [0x0f, 0, 0, ...word(quantity), bytes, ...zeros(bytes)]));
  };
  const registers = (quantity: number) =>
    said(readPdu('request', [0x10, 0, 0, ...word(quantity), 2 * quantity, ...zeros(2 * quantity)]));

  test('at 800 coils', () => {
    expect(coils(800)).toEqual([]);
    expect(coils(801)).toEqual(['note old-controller-limit']);
  });
  test('at 100 registers', () => {
    expect(registers(100)).toEqual([]);
    expect(registers(101)).toEqual(['note old-controller-limit']);
  });
});
