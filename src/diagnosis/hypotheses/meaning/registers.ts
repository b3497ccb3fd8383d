import type { Reading } from '../../../modbus/index.ts';
import { type Case, isClean } from '../../case.ts';
import type { Offer } from '../../finding.ts';
import { replaced, swapWord } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { bodyOf, carriedBy } from '../../request.ts';
import { faulty, problemOf, said } from './whole.ts';

/** Hints have less evidence than whatever the bytes prove. */
const HINT = 3;
/** Most measured values are below this; with their bytes exchanged most are above it. */
const SMALL = 0x0fff;
/** The high half of most 32-bit numbers lies within this of zero. */
const NEAR_ZERO = 0xff;
const LEAST_FOR_PAIRS = 4;
const REGISTER_LISTS = ['registers', 'writeRegisters', 'value'];

/** Registers whose bytes or quantity look like those of another convention. */
export const registers: Hypothesis = {
  codes: ['register-bytes-swapped', 'quantity-in-32-bit'],
  offer: (item) => [
    ...echoedSwapped(item),
    ...item.wholes
      .filter((whole) => isClean(whole) && whole.reading.transport !== 'pdu')
      .flatMap(({ reading }) => [...swapped(item, reading), ...pairs(reading)])
      .slice(0, 2),
  ],
};

function listOf({ fields, spans }: Reading): { values: readonly number[]; from: number; to: number } | undefined {
  const span = spans.find(({ name }) => REGISTER_LISTS.includes(name));
  const found = span && fields[span.name];
  const list = typeof found === 'number' ? [found] : found;
  return span && Array.isArray(list) ? { values: list as number[], from: span.from, to: span.to } : undefined;
}

function swapped({ bytes }: Case, reading: Reading): Offer[] {
  const list = listOf(reading);
  const body = bodyOf(reading, bytes);
  if (list === undefined || body === undefined || reading.transport === 'ascii') return [];
  const telling = list.values.filter((value) => value !== swapWord(value));
  const [got] = telling;
  if (got === undefined || telling.some((value) => value <= SMALL || swapWord(value) > SMALL)) return [];
  // Negative numbers are large in both orders.
  const before = reading.transport === 'tcp' ? 6 : 0;
  let turned = body;
  list.values.forEach((value, i) => {
    turned = replaced(turned, list.from - before + 2 * i, value & 0xff, value >>> 8);
  });
  const repaired = [carriedBy(reading.transport, turned, reading.transactionId)];
  const { from, to } = list;
  return [{ code: 'register-bytes-swapped', from, to, got, swapped: swapWord(got), repaired, bits: HINT }];
}

/** Every second register is nearly zero: the registers are halves of 32-bit numbers. */
function pairs(reading: Reading): Offer[] {
  const list = listOf(reading);
  if (list === undefined || reading.direction !== 'response') return [];
  const { values, from, to } = list;
  if (values.length < LEAST_FOR_PAIRS || values.length % 2 !== 0) return [];
  const near = (value: number) => value <= NEAR_ZERO || value >= 0x10000 - NEAR_ZERO;
  const halves = [0, 1].map((half) => values.filter((_, i) => i % 2 === half).every(near));
  if (halves[0] === halves[1]) return [];
  const bytes = 2 * values.length;
  return [{ code: 'quantity-in-32-bit', from, to, got: bytes, expected: 2 * bytes, repaired: [], bits: HINT - 1 }];
}

/** A write whose reply repeats the value with its bytes exchanged. */
function echoedSwapped(item: Case): Offer[] {
  const whole = faulty(item);
  const differs = whole && problemOf(whole, 'echo-differs');
  const asked = item.request?.reading.fields['value'];
  const got = whole?.reading.fields['value'];
  if (
    whole === undefined ||
    differs?.field !== 'value' ||
    typeof asked !== 'number' ||
    typeof got !== 'number' ||
    swapWord(got) !== asked
  )
    return [];
  const { from, to } = differs.span;
  return [{ code: 'register-bytes-swapped', from, to, got, swapped: asked, repaired: [], bits: said(whole, 9) }];
}
