import type { FloatType } from '../number-type.ts';

const MOST = 0x7f_ffff;
const POWER = 127;

/** A power of ten as a signed byte, and behind it a signed number of 24 bits: 0xFD 0xFE1DC0 is −123456 × 10^−3. */
export const decimalFloat: FloatType = {
  kind: 'float',
  registers: 2,
  least: -MOST * 10 ** POWER,
  most: MOST * 10 ** POWER,
  digits: 7,
  finite: true,
  read: (view) => Number(`${(view.getInt32(0) << 8) >> 8}e${view.getInt8(0)}`),
  write: (view, value) => {
    let [number, power] = partsOf(Number(value));
    while (Math.abs(number) > MOST || power < -POWER - 1) {
      number = Math.round(number / 10);
      power += 1;
    }
    for (; power > POWER && Math.abs(number) * 10 <= MOST; power--) number *= 10;
    view.setInt32(0, ((power & 0xff) << 24) | (number & 0xff_ffff));
  },
};

/** A number as a whole one of at most nine digits and a power of ten. */
function partsOf(value: number): [number, number] {
  const [digits = '0', power = '0'] = Number(value.toPrecision(9)).toExponential().split('e');
  const [whole = '0', behind = ''] = digits.split('.');
  return [Number(whole + behind), value === 0 ? 0 : Number(power) - behind.length];
}
