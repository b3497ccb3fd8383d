import { demandWhole } from '../demand.ts';

/**
 * The byte orders, named by the places of the bytes of a 32-bit value: A is its highest byte. Each is one choice of the
 * order of the registers and one of the bytes inside each. Registers themselves travel high byte first (AP 4.2); how a value
 * spans several registers is up to the device.
 */
export const orders = {
  ABCD: { lowRegisterFirst: false, lowByteFirst: false },
  CDAB: { lowRegisterFirst: true, lowByteFirst: false },
  BADC: { lowRegisterFirst: false, lowByteFirst: true },
  DCBA: { lowRegisterFirst: true, lowByteFirst: true },
} as const;

export type Order = keyof typeof orders;

const allOrders = Object.keys(orders) as readonly Order[];

/** The orders that differ for a value of a number of registers: two for one register, four for more. */
export const ordersOf = (registers: number): readonly Order[] =>
  registers === 1 ? allOrders.filter((order) => !orders[order].lowRegisterFirst) : allOrders;

/** The bytes of a value, high byte first, as the registers that hold it in this order. `bytes` has an even length. */
export function toRegisters(bytes: Uint8Array, order: Order): number[] {
  const { lowRegisterFirst, lowByteFirst } = orders[order];
  const high = lowByteFirst ? 1 : 0;
  const registers = Array.from(
    { length: bytes.length / 2 },
    (_, index) => ((bytes[2 * index + high] as number) << 8) | (bytes[2 * index + 1 - high] as number),
  );
  return lowRegisterFirst ? registers.reverse() : registers;
}

/**
 * The bytes, high byte first, of the value that registers hold in this order. Throws a `RangeError` unless they are 0…65535.
 */
export function fromRegisters(registers: readonly number[], order: Order): Uint8Array {
  const { lowRegisterFirst, lowByteFirst } = orders[order];
  const bytes = new Uint8Array(2 * registers.length);
  registers.forEach((register, index) => {
    demandWhole('register', register, 0, 0xffff);
    const at = 2 * (lowRegisterFirst ? registers.length - 1 - index : index);
    bytes[at] = lowByteFirst ? register & 0xff : register >>> 8;
    bytes[at + 1] = lowByteFirst ? register >>> 8 : register & 0xff;
  });
  return bytes;
}

/**
 * The name of an order for a value of a number of registers: `AB` or `BA`, `CDAB`, `GHEFCDAB`. Throws a `RangeError` for more
 * registers than the alphabet has letters for.
 */
export function orderName(order: Order, registers: number): string {
  demandWhole('registers', registers, 0, 13);
  const letters = Uint8Array.from({ length: 2 * registers }, (_, index) => 0x41 + index);
  return toRegisters(letters, order)
    .map((pair) => String.fromCharCode(pair >>> 8, pair & 0xff))
    .join('');
}
