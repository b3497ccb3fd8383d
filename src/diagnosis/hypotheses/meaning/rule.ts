import { decodeFrame, type Problem, type ProblemCode } from '../../../modbus/index.ts';
import type { Case } from '../../case.ts';
import type { Offer } from '../../finding.ts';
import { DIRECTIONS } from '../../frames.ts';
import type { Hypothesis } from '../../hypothesis.ts';
import { requestAs } from '../../request.ts';
import { faulty, said } from './whole.ts';

/** Problems that other findings cover. */
const TOLD_ELSEWHERE = new Set<ProblemCode>([
  'frame-short',
  'frame-extra',
  'checksum-wrong',
  'pdu-short',
  'pdu-rest',
  'count-wrong',
  'count-contradicts-quantity',
  'mbap-length-wrong',
  'unit-not-as-requested',
  'transaction-not-as-requested',
  'function-not-as-requested',
  'count-not-as-requested',
  'broadcast-answered',
  'coil-value-illegal',
  'padding-not-zero',
]);

/** The fields do not end where the frame ends, or have an impossible count. */
const SHAPELESS = new Set<ProblemCode>(['pdu-short', 'pdu-rest', 'count-wrong', 'count-out-of-range']);

const COLON = 0x3a;
/** If there is a colon, the bytes in front of it are stray. */
const FOUND_COLON = new Set<ProblemCode>(['ascii-start']);

/** Any other rule of the specification that is broken. */
export const rule: Hypothesis = {
  codes: ['rule-broken'],
  offer: (item) => {
    const whole = faulty(item);
    if (whole === undefined) return unread(item);
    const { problems } = whole.reading;
    // If the fields do not end with the frame, their values are not what was meant.
    const shapeless = problems.some(({ code }) => SHAPELESS.has(code));
    return offersOf(problems, shapeless ? 1 : said(whole, 20), item.bytes.includes(COLON) ? FOUND_COLON : undefined);
  },
};

/** What is wrong with bytes that are not a frame of the transport that they should have. */
function unread({ bytes, transport, request, wholes, cut }: Case): Offer[] {
  if (cut || wholes.length > 0 || transport === undefined || transport === 'rtu') return [];
  const readings = DIRECTIONS.map((direction) => {
    const asked = direction === 'response' ? requestAs(request, transport, bytes) : undefined;
    return decodeFrame(bytes, { transport, direction, request: asked });
  });
  const problems = readings.map((reading) => reading.problems).reduce((a, b) => (b.length < a.length ? b : a));
  return offersOf(problems, 1);
}

const offersOf = (problems: readonly Problem[], bits: number, told?: ReadonlySet<ProblemCode>): Offer[] =>
  problems
    .filter(({ code, severity }) => severity === 'error' && !TOLD_ELSEWHERE.has(code) && !told?.has(code))
    .slice(0, 1)
    .map((problem) => ({
      code: 'rule-broken',
      from: problem.span.from,
      to: problem.span.to,
      problem,
      repaired: [],
      bits,
    }));
