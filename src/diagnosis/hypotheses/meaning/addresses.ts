import { describeFunction, fieldValue, type Reading, type Table, tableDigits, twinOf } from '../../../modbus/index.ts';
import { type Case, isClean } from '../../case.ts';
import type { Offer } from '../../finding.ts';
import { replaced, word } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { bodyOf, carriedBy } from '../../request.ts';
import { faulty, problemOf, said } from './whole.ts';

/** A hint has less evidence than whatever the bytes prove. */
const HINT = 4;
/** Tables whose five-digit numbers can be told from addresses. */
const NUMBERED: readonly Table[] = ['discrete-input', 'input-register', 'holding-register'];
const NUMBERS = 10000;
const NO_SUCH_FUNCTION = 0x01;
const NO_SUCH_ADDRESS = 0x02;
/** The place of the address, behind unit identifier and function code. */
const ADDRESS_AT = 2;
/** The names of a request's first address; other addresses are not places in a table. */
const ADDRESSES = ['startAddress', 'address'];

/** Addresses and element numbers were confused. */
export const addresses: Hypothesis = {
  codes: ['address-is-number', 'address-off-by-one', 'function-of-other-table'],
  offer: (item) => [...numbers(item), ...echoedNextTo(item)],
};

/** The request in question: these bytes, or the one they refuse, with the reason. */
function requestIn({
  wholes,
  request,
  bytes,
}: Case): { reading: Reading; frame: Uint8Array; refused: number } | undefined {
  const clean = wholes.filter(isClean).map(({ reading }) => reading);
  const refused = clean.find(({ fields }) => 'exceptionCode' in fields)?.fields['exceptionCode'];
  if (request)
    return typeof refused === 'number' ? { reading: request.reading, frame: request.bytes, refused } : undefined;
  const own = clean.find(({ direction }) => direction === 'request');
  return own && { reading: own, frame: bytes, refused: 0 };
}

function numbers(item: Case): Offer[] {
  const asked = requestIn(item);
  const body = asked && bodyOf(asked.reading, asked.frame);
  const address =
    asked && ADDRESSES.map((name) => fieldValue(asked.reading, name)).find((value) => typeof value === 'number');
  if (asked === undefined || body === undefined || typeof address !== 'number') return [];
  const { reading, refused } = asked;
  const { functionCode = 0, transport, transactionId } = reading;
  const change = (code: number, to: number) => [
    carriedBy(transport, replaced(body, 1, code, to >>> 8, to & 0xff), transactionId),
  ];
  const place = { from: 0, to: item.bytes.length };
  const { table } = describeFunction(functionCode, 'request');
  const twin = twinOf(functionCode);
  const offers: Offer[] = [];
  for (const numbered of NUMBERED) {
    const before = Number(tableDigits[numbered]) * NUMBERS;
    const within = address - before;
    if (within < 0 || within >= NUMBERS || table === undefined) continue;
    const number = before + Math.max(1, within);
    const meant = Math.max(0, within - 1);
    if (numbered === table) {
      const repaired = change(functionCode, meant);
      offers.push({ code: 'address-is-number', ...place, number, address: meant, repaired, bits: HINT });
    } else if (twin?.table === numbered) {
      const repaired = change(twin.code, meant);
      offers.push({
        code: 'function-of-other-table',
        ...place,
        functionCode,
        meant: twin.code,
        number,
        repaired,
        bits: HINT,
      });
    }
  }
  if (refused === NO_SUCH_ADDRESS && address > 0) {
    const repaired = change(functionCode, address - 1);
    offers.push({
      code: 'address-off-by-one',
      ...place,
      got: address,
      expected: address - 1,
      repaired,
      bits: HINT - 1,
    });
  }
  if ((refused === NO_SUCH_ADDRESS || refused === NO_SUCH_FUNCTION) && twin !== undefined) {
    const repaired = change(twin.code, address);
    offers.push({
      code: 'function-of-other-table',
      ...place,
      functionCode,
      meant: twin.code,
      number: undefined,
      repaired,
      bits: HINT - 2,
    });
  }
  return offers;
}

/** A reply that repeats the address next to the one it was asked for. */
function echoedNextTo(item: Case): Offer[] {
  const whole = faulty(item);
  const differs = whole && problemOf(whole, 'echo-differs');
  if (item.request === undefined || whole === undefined || differs === undefined || !ADDRESSES.includes(differs.field))
    return [];
  const got = whole.reading.fields[differs.field];
  const expected = word(item.request.pdu, ADDRESS_AT - 1);
  if (typeof got !== 'number' || Math.abs(got - expected) !== 1) return [];
  const { from, to } = differs.span;
  return [{ code: 'address-off-by-one', from, to, got, expected, repaired: [], bits: said(whole, 9) }];
}
