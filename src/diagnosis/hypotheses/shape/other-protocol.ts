import type { Hypothesis } from '../../hypothesis.ts';
import { otherProtocolOf } from '../../other-protocols.ts';

/** The bytes are a message of another protocol. */
export const otherProtocol: Hypothesis = {
  codes: ['other-protocol'],
  offer: ({ bytes }) => {
    const found = otherProtocolOf(bytes);
    return found === undefined ? [] : [{ code: 'other-protocol', from: 0, to: bytes.length, repaired: [], ...found }];
  },
};
