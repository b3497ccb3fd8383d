import {
  BROADCAST,
  describeFunction,
  type Field,
  fieldsOf,
  mostOf,
  type Reading,
  readerOf,
  toHex,
} from '../../modbus/index.ts';
import type { Draft } from './draft.ts';
import { type Evaluation, evaluate } from './evaluate.ts';
import { alone } from './pair.ts';

/** What a device will answer to a request. */
export type ExpectedReply =
  | { readonly kind: 'none'; readonly why: 'broadcast' | 'silent' }
  | {
      /** Exact: every byte follows from the request. Layout: its length does. Open: neither. */
      readonly kind: 'exact' | 'layout' | 'open';
      readonly draft: Draft;
      readonly evaluation: Evaluation;
    };

/** The reply that a request will get, as a draft that can be built on. */
export function expectReply(draft: Draft, reading: Reading, bytes: Uint8Array): ExpectedReply {
  const { transport, unitId, functionCode = 0, fields } = reading;
  if (unitId === BROADCAST && (transport === 'rtu' || transport === 'ascii')) return { kind: 'none', why: 'broadcast' };
  const list = [...fieldsOf(describeFunction(functionCode, 'response'), 'response', fields)].map(({ field }) => field);
  const asked = askedFor(reading, list);
  const kind = list.every((field) => field.derive || field.replyRules.length > 0) ? 'exact' : asked ? 'layout' : 'open';
  const texts = { ...draft.texts, ...asked };
  for (const [name, value] of Object.entries(reading.derived)) {
    if (list.some((field) => field.name === name && !field.derive)) texts[name] = String(value);
  }
  const reply: Draft = { ...draft, kind: 'reply', texts, force: {}, answering: toHex(bytes), partner: alone(draft) };
  const evaluation = evaluate(reply);
  const silent = evaluation.frame?.reading.problems.some(({ code }) => code === 'sub-function-without-reply');
  return silent ? { kind: 'none', why: 'silent' } : { kind, draft: reply, evaluation };
}

/** The exception that refuses a request. */
export const exceptionTo = (draft: Draft, bytes: Uint8Array): Draft => ({
  ...draft,
  kind: 'exception',
  texts: { ...draft.texts, exceptionCode: '2' },
  force: {},
  answering: toHex(bytes),
  partner: alone(draft),
});

/** Most elements that one request reads. */
const MOST = mostOf(readerOf('coil'));

/** As many zeros as were asked for, where a quantity in the request decides the reply's length. */
function askedFor({ fields }: Reading, list: readonly Field[]): Record<string, string> | undefined {
  const quantity = fields['quantity'] ?? fields['readQuantity'];
  const values = list.find(({ kind }) => kind === 'registers' || kind === 'bits');
  if (typeof quantity !== 'number' || values === undefined || quantity > MOST) return undefined;
  return { [values.name]: Array.from({ length: quantity }, () => 0).join(' ') };
}
