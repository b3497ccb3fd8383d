import { type CatalogueCrc, demandWhole, ownCrc, polynomialForms } from '../../modbus/index.ts';
import { readNumber } from '../../notation/index.ts';
import { registerHex } from './register-text.ts';

/** The ways a polynomial is written. */
export const polynomialKinds = ['normal', 'reversed', 'koopman'] as const;
export type PolynomialKind = (typeof polynomialKinds)[number];

const numbers = ['width', 'poly', 'init', 'xorout'] as const;
export type OwnNumber = (typeof numbers)[number];

/** Own parameters, as typed. */
export interface OwnTexts extends Readonly<Record<OwnNumber, string>> {
  readonly refin: boolean;
  readonly refout: boolean;
  readonly polyAs: PolynomialKind;
}

export const noOwn: OwnTexts = {
  width: '',
  poly: '',
  init: '',
  xorout: '',
  refin: false,
  refout: false,
  polyAs: 'normal',
};

/** Why a text is not a parameter; `most` is the largest legal value. */
export type OwnFault =
  | { readonly code: 'missing' }
  | { readonly code: 'not-a-number'; readonly text: string }
  | { readonly code: 'out-of-range'; readonly least: number; readonly most: number };

export interface OwnReading {
  /** The algorithm, if all parameters are there. */
  readonly crc?: CatalogueCrc;
  readonly faults: Readonly<Partial<Record<OwnNumber, OwnFault>>>;
  /** What each text says, where it says anything. */
  readonly values: Readonly<Partial<Record<OwnNumber, number>>>;
}

const WIDEST = 32;

/** Reads parameters as typed. Start value and final xor are zero if nothing is typed. */
export function readOwn(texts: OwnTexts): OwnReading {
  if (numbers.every((name) => texts[name].trim() === '')) return { faults: {}, values: {} };
  const faults: Partial<Record<OwnNumber, OwnFault>> = {};
  const values: Partial<Record<OwnNumber, number>> = {};
  const read = (name: OwnNumber, least: number, most: number, otherwise?: number) => {
    const text = texts[name].trim();
    const value = text === '' ? otherwise : readNumber(text);
    if (value === undefined) faults[name] = text === '' ? { code: 'missing' } : { code: 'not-a-number', text };
    else if (!Number.isInteger(value) || value < least || value > most) {
      faults[name] = { code: 'out-of-range', least, most };
    } else values[name] = value;
    return values[name];
  };
  const width = read('width', 1, WIDEST);
  const most = 2 ** (width ?? WIDEST) - 1;
  const poly = read('poly', 0, most);
  const init = read('init', 0, most, 0);
  const xorout = read('xorout', 0, most, 0);
  if (width === undefined || poly === undefined || init === undefined || xorout === undefined)
    return { faults, values };
  const { refin, refout, polyAs } = texts;
  const parameters = { width, poly: asNormal(poly, width, polyAs), init, refin, refout, xorout };
  // Its name tells it from another with other parameters.
  const name = `own ${Object.values(parameters).join(' ')}`;
  return { crc: ownCrc(name, parameters), faults, values };
}

function asNormal(poly: number, width: number, as: PolynomialKind): number {
  if (as === 'reversed') return polynomialForms({ width, poly }).reversed;
  // Without its top bit and with the one that is left out at the bottom.
  return as === 'koopman' ? ((poly % 2 ** (width - 1)) * 2 + 1) >>> 0 : poly;
}

/** The texts that say the parameters of a row. */
export function ownTexts({ width, poly, init, refin, refout, xorout }: CatalogueCrc): OwnTexts {
  const hex = (value: number) => registerHex(width, value);
  return {
    width: String(width),
    poly: hex(poly),
    init: hex(init),
    xorout: hex(xorout),
    refin,
    refout,
    polyAs: 'normal',
  };
}

/** A polynomial as it is written down: `x^16 + x^15 + x^2 + 1`. Throws a `RangeError` for a width other than 1 to 32. */
export function powersOf({ width, poly }: Pick<CatalogueCrc, 'width' | 'poly'>): string {
  demandWhole('width', width, 1, 32);
  const powers = [width];
  for (let power = width - 1; power >= 0; power--) if ((poly >>> power) & 1) powers.push(power);
  return powers.map((power) => (power === 0 ? '1' : power === 1 ? 'x' : `x^${power}`)).join(' + ');
}
