import type { Case, WholeFrame } from '../../case.ts';
import type { Offer } from '../../finding.ts';
import { join, replaced } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { bodyOf, carriedBy } from '../../request.ts';
import { faulty, problemOf, said } from './whole.ts';

/** Values that a coil cannot have, and bits beyond the quantity that are set. */
export const values: Hypothesis = {
  codes: ['coil-value-illegal', 'padding-bits'],
  offer: (item) => {
    const whole = faulty(item);
    return whole ? [...coil(item, whole), ...padding(item, whole)] : [];
  },
};

/** The bytes before the value: unit identifier, function code, address. */
const COIL_AT = 4;

function coil({ bytes }: Case, whole: WholeFrame): Offer[] {
  const { reading } = whole;
  const wrong = problemOf(whole, 'coil-value-illegal');
  const body = bodyOf(reading, bytes);
  if (wrong === undefined || body === undefined) return [];
  const { got, span } = wrong;
  const to = (high: number) => carriedBy(reading.transport, replaced(body, COIL_AT, high, 0), reading.transactionId);
  const { from, to: end } = span;
  // Anything but 0 was meant as ON by whoever sent it.
  return [{ code: 'coil-value-illegal', from, to: end, got, repaired: [to(0xff), to(0x00)], bits: said(whole, 7) }];
}

function padding({ bytes }: Case, whole: WholeFrame): Offer[] {
  const { reading } = whole;
  const wrong = problemOf(whole, 'padding-not-zero');
  const body = bodyOf(reading, bytes);
  const list = reading.fields['bits'];
  if (wrong === undefined || body === undefined || !Array.isArray(list)) return [];
  const used = list.length % 8;
  const last = (body[body.length - 1] as number) & (0xff >> (8 - used));
  const repaired = carriedBy(reading.transport, join(body.subarray(0, -1), [last]), reading.transactionId);
  const { to } = wrong.span;
  const found = { from: to - (reading.transport === 'ascii' ? 2 : 1), to, repaired: [repaired] };
  return [{ code: 'padding-bits', ...found, quantity: list.length, got: wrong.got, bits: said(whole, 8) }];
}
