import { demandWhole } from '../demand.ts';

/** Which registers come first: those of the highest bytes, the lowest, or pairs of registers in one and inside in the other order. */
type RegisterOrder = 'high-first' | 'low-first' | 'low-first-in-pairs' | 'low-pair-first';

/**
 * The byte orders, named by the places of the bytes of a 32-bit value, or of 64 bits where these have an order of their own: A is
 * its highest byte. Each is a choice of the order of the registers and one of the bytes inside each. Registers themselves
 * travel high byte first (AP 4.2); how a value spans several registers is up to the device.
 */
export const orders = {
  ABCD: { registers: 'high-first', lowByteFirst: false },
  CDAB: { registers: 'low-first', lowByteFirst: false },
  BADC: { registers: 'high-first', lowByteFirst: true },
  DCBA: { registers: 'low-first', lowByteFirst: true },
  CDABGHEF: { registers: 'low-first-in-pairs', lowByteFirst: false },
  EFGHABCD: { registers: 'low-pair-first', lowByteFirst: false },
  DCBAHGFE: { registers: 'low-first-in-pairs', lowByteFirst: true },
  FEHGBADC: { registers: 'low-pair-first', lowByteFirst: true },
} as const satisfies Readonly<Record<string, { registers: RegisterOrder; lowByteFirst: boolean }>>;

export type Order = keyof typeof orders;

/** A text may have many. */
const MOST_REGISTERS = 1_000_000;

const allOrders = Object.keys(orders) as readonly Order[];

/** The orders that differ for a value of a number of registers: two for one register, four for two and three, eight for four. */
export const ordersOf = (registers: number): readonly Order[] => ORDERS_OF[registers] ?? allOrders;

const ORDERS_OF: Readonly<Record<number, readonly Order[]>> = {
  1: ['ABCD', 'BADC'],
  2: allOrders.slice(0, 4),
  3: allOrders.slice(0, 4),
};

/**
 * Which registers of a value stand where: at each place, the register as counted from the highest bytes. Throws a `RangeError`
 * for more than a million.
 */
export function registerPlaces(order: Order, registers: number): number[] {
  demandWhole('registers', registers, 0, MOST_REGISTERS);
  return Array.from({ length: registers }, (_, index) => placeOf(order, registers, index));
}

function placeOf(order: Order, registers: number, index: number): number {
  const { registers: first } = orders[order];
  const four = registers % 4 === 0;
  if (first === 'high-first' || (first === 'low-pair-first' && !four)) return index;
  if (first === 'low-pair-first') return index ^ 2;
  return first === 'low-first-in-pairs' && four ? index ^ 1 : registers - 1 - index;
}

/** The bytes of a value, high byte first, as the registers that hold it in this order. `bytes` has an even length. */
export function toRegisters(bytes: Uint8Array, order: Order): number[] {
  const high = orders[order].lowByteFirst ? 1 : 0;
  return registerPlaces(order, bytes.length / 2).map(
    (place) => ((bytes[2 * place + high] as number) << 8) | (bytes[2 * place + 1 - high] as number),
  );
}

/**
 * The bytes, high byte first, of the value that registers hold in this order; `into`, of twice as many bytes, takes them. Throws a
 * `RangeError` unless the registers are 0…65535.
 */
export function fromRegisters(
  registers: readonly number[],
  order: Order,
  into: Uint8Array = new Uint8Array(2 * registers.length),
): Uint8Array {
  demandWhole('registers', registers.length, 0, MOST_REGISTERS);
  const { lowByteFirst } = orders[order];
  registers.forEach((register, index) => {
    demandWhole('register', register, 0, 0xffff);
    const at = 2 * placeOf(order, registers.length, index);
    into[at] = lowByteFirst ? register & 0xff : register >>> 8;
    into[at + 1] = lowByteFirst ? register >>> 8 : register & 0xff;
  });
  return into;
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
