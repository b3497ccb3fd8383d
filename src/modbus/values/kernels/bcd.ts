import { toHex } from '../../hex.ts';
import { type NumberType, numberType } from '../number-type.ts';

/** The bytes of a view as hexadecimal digits. */
const hexOf = (view: DataView): string => toHex(new Uint8Array(view.buffer, view.byteOffset, view.byteLength));

function writeDigits(view: DataView, digits: string): void {
  for (let at = 0; at < view.byteLength; at++) view.setUint8(at, Number.parseInt(digits.slice(2 * at, 2 * at + 2), 16));
}

/** Binary coded decimal: four bits a digit, none of them above 9. */
export function bcd(registers: 1 | 2 | 4): NumberType {
  const digits = 4 * registers;
  return numberType({
    kind: 'bcd',
    registers,
    least: 0n,
    most: 10n ** BigInt(digits) - 1n,
    read: (view) => (/^\d+$/.test(hexOf(view)) ? BigInt(hexOf(view)) : undefined),
    write: (view, value) => writeDigits(view, String(value).padStart(digits, '0')),
  });
}

/** BCD whose highest digit is the sign: 0 or C for +, 8, D or F for −; F is written, as in Siemens and Yokogawa devices. */
export function signedBcd(registers: 1 | 2): NumberType {
  const digits = 4 * registers - 1;
  const most = 10n ** BigInt(digits) - 1n;
  return numberType({
    kind: 'bcd',
    registers,
    least: -most,
    most,
    read: (view) => {
      const [, sign = '', size = ''] = /^([08CDF])(\d+)$/.exec(hexOf(view)) ?? [];
      if (size === '') return undefined;
      return sign === '0' || sign === 'C' ? BigInt(size) : -BigInt(size);
    },
    write: (view, value) => {
      const size = String(value < 0n ? -value : value).padStart(digits, '0');
      writeDigits(view, `${value < 0n ? 'F' : '0'}${size}`);
    },
  });
}
