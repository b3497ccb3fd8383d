import type { Reading, Span } from '../../../modbus/index.ts';
import type { Case, WholeFrame } from '../../case.ts';
import type { Offer } from '../../finding.ts';
import { replaced, swapWord } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { faulty, problemOf, said } from './whole.ts';

/** A whole reply that does not answer its request. */
export const againstRequest: Hypothesis = {
  codes: [
    'unit-mismatch',
    'broadcast-answered',
    'function-mismatch',
    'exception-of-other-function',
    'transaction-swapped',
    'transaction-mismatch',
    'quantity-mismatch',
    'quantity-in-32-bit',
  ],
  offer: (item) => {
    const whole = item.request && faulty(item);
    if (whole === undefined) return [];
    return [...addressed(whole), ...answered(whole), ...transaction(item, whole), ...counted(whole)];
  },
};

const at = ({ from, to }: Span) => ({ from, to, repaired: [] });

function addressed(whole: WholeFrame): Offer[] {
  const broadcast = problemOf(whole, 'broadcast-answered');
  if (broadcast) return [{ code: 'broadcast-answered', ...at(broadcast.span), bits: said(whole, 1) }];
  const unit = problemOf(whole, 'unit-not-as-requested');
  if (unit === undefined) return [];
  return [{ code: 'unit-mismatch', ...at(unit.span), got: unit.got, expected: unit.expected, bits: said(whole, 2) }];
}

function answered(whole: WholeFrame): Offer[] {
  const other = problemOf(whole, 'function-not-as-requested');
  if (other === undefined) return [];
  const found = { ...at(other.span), got: other.got, expected: other.expected, bits: said(whole, 3) };
  const { functionCode = 0, fields } = whole.reading;
  const exceptionCode = fields['exceptionCode'];
  return functionCode >= 0x80 && typeof exceptionCode === 'number'
    ? [{ code: 'exception-of-other-function', exceptionCode, ...found }]
    : [{ code: 'function-mismatch', ...found }];
}

function transaction({ bytes }: Case, whole: WholeFrame): Offer[] {
  const other = problemOf(whole, 'transaction-not-as-requested');
  if (other === undefined) return [];
  const { got, expected, span } = other;
  const place = { ...at(span), got, expected, repaired: [replaced(bytes, 0, expected >>> 8, expected & 0xff)] };
  return swapWord(got) === expected
    ? [{ code: 'transaction-swapped', ...place, bits: said(whole, 0) }]
    : [{ code: 'transaction-mismatch', ...place, bits: said(whole, 4) }];
}

/** The functions whose quantity is of registers: bits do not come in pairs. */
const hasRegisters = ({ description }: Reading) =>
  description?.table === 'holding-register' || description?.table === 'input-register';

function counted(whole: WholeFrame): Offer[] {
  const count = problemOf(whole, 'count-not-as-requested');
  if (count === undefined || problemOf(whole, 'count-wrong') || problemOf(whole, 'count-out-of-range')) return [];
  const { got, expected, span } = count;
  const found = { ...at(span), got, expected };
  return hasRegisters(whole.reading) && (got === 2 * expected || expected === 2 * got)
    ? [{ code: 'quantity-in-32-bit', ...found, bits: said(whole, 5) }]
    : [{ code: 'quantity-mismatch', ...found, bits: said(whole, 6) }];
}
