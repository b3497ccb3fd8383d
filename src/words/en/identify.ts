import type { Identity, Reason, ReasonCode } from '../../diagnosis/index.ts';
import { bytesOf, code, page, plural } from './common.ts';

type Sentence<C extends ReasonCode> = (reason: Extract<Reason, { code: C }>) => string;

/** What each reason says for a reading of bytes, or against it: half a sentence, to be listed with others. */
const reasons: { readonly [C in ReasonCode]: Sentence<C> } = {
  'checksum-holds': ({ algorithm }) => `${algorithm.toUpperCase()} holds`,
  'checksum-wrong': ({ algorithm }) => `${algorithm.toUpperCase()} does not hold`,
  'mbap-fits': ({ length }) => `MBAP header: protocol identifier 0, and its length, ${length}, is right`,
  'mbap-length-differs': ({ got, expected }) =>
    `MBAP header: protocol identifier 0, but its length says ${got} where ${bytesOf(expected)} follow`,
  'no-mbap': () => 'no MBAP header: the protocol identifier is not 0',
  colon: () => 'starts with a colon',
  'no-colon': () => 'no colon',
  'hex-digits': () => 'all characters are hexadecimal digits',
  'other-characters': ({ others }) => `${plural(others, 'character is', 'characters are')} not hexadecimal digits`,
  'bare-pdu': ({ fits }) =>
    fits ? 'would be right without unit and checksum' : 'would have neither unit nor checksum, and still not fit',
  'frame-inside': ({ from, to }) => `a whole frame is in bytes ${from} to ${to - 1}, with others around it`,
  'known-function': ({ functionCode }) =>
    functionCode < 0x80
      ? `function ${code(functionCode)} is known`
      : `an exception to function ${code(functionCode & 0x7f)}`,
  'function-serial-only': ({ functionCode }) => `function ${code(functionCode)} is for serial lines only`,
  'unknown-function': ({ functionCode }) => `function ${code(functionCode)} is not a public one`,
  'fields-fit': () => 'the length is right for this function',
  'byte-count-fits': ({ got, registers }) =>
    registers === undefined ? `byte count ${got} is right` : `byte count ${got} = ${plural(registers, 'register')}`,
  'fields-do-not-fit': () => 'the length is wrong for this function',
  'length-short': ({ missing }) => `at least ${bytesOf(missing)} missing`,
  'length-extra': ({ bytes }) => `${bytesOf(bytes)} too many`,
  'rules-broken': ({ errors }) => `${plural(errors, 'value')} not allowed`,
  'against-advice': ({ warnings }) => `${plural(warnings, 'value')} reserved or unusual`,
  'answers-request': () => 'answers the request',
  'answers-another': () => 'does not answer the request',
  'repeats-request': () => 'repeats the request byte for byte',
  'direction-given': () => 'the direction is as given',
  'transport-given': () => 'the transport is as chosen',
  'same-either-way': () => 'request and reply look the same',
};

/** They tell the transport; the others tell the direction. */
const OF_TRANSPORT: ReadonlySet<ReasonCode> = new Set<ReasonCode>([
  'checksum-holds',
  'checksum-wrong',
  'mbap-fits',
  'mbap-length-differs',
  'no-mbap',
  'colon',
  'no-colon',
  'hex-digits',
  'other-characters',
  'bare-pdu',
  'frame-inside',
  'transport-given',
]);

const because = (what: string, whys: readonly Reason[]): string =>
  whys.length === 0 ? what : `${what}: ${whys.map(sentence).join(', ')}`;

const sentence = (reason: Reason): string => (reasons[reason.code] as (one: Reason) => string)(reason);

/** What bytes are, and why: `RTU: CRC holds; reply: function 03 is known, byte count 8 = 4 registers`. */
function summary({
  transport,
  direction,
  reasons: whys,
}: Pick<Identity, 'transport' | 'direction' | 'reasons'>): string {
  const ofTransport = whys.filter(({ code: one }) => OF_TRANSPORT.has(one));
  const others = whys.filter(({ code: one }) => !OF_TRANSPORT.has(one));
  return `${because(page.transports[transport], ofTransport)}; ${because(page.directions[direction], others)}`;
}

/** The sentences about what bytes are. */
export const identify = { reasons, summary };
export type IdentifyWords = typeof identify;
