import { type NumberType, numberType } from '../number-type.ts';

const BASE = 10_000n;

/**
 * Modulo 10,000: each register has four decimal digits, −9999 to 9999, and counts 10,000 times the one below (PowerLogic and ION
 * meters, where the lowest register mostly comes first).
 */
export function mod10k(registers: 2 | 3 | 4): NumberType {
  const most = BASE ** BigInt(registers) - 1n;
  return numberType({
    kind: 'integer',
    registers,
    least: -most,
    most,
    read: (view) => {
      let value = 0n;
      for (let at = 0; at < 2 * registers; at += 2) {
        const digits = view.getInt16(at);
        if (Math.abs(digits) >= Number(BASE)) return undefined;
        value = value * BASE + BigInt(digits);
      }
      return value;
    },
    write: (view, value) => {
      for (let at = 2 * registers - 2, rest = value; at >= 0; at -= 2, rest /= BASE)
        view.setInt16(at, Number(rest % BASE));
    },
  });
}
