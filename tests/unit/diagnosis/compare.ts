import { type Cause, type Comparison, compareFrames } from '../../../src/diagnosis/index.ts';
import { type DecodeContext, fromHex } from '../../../src/modbus/index.ts';

/** Two frames as hexadecimal pairs, or in quotes as characters, and what is to be said of them. */
export interface Case {
  readonly what: string;
  readonly mine: string;
  readonly theirs: string;
  readonly context?: Partial<Omit<DecodeContext, 'request'>> & { readonly request?: string };
  /** Of the whole frame. */
  readonly causes?: readonly Cause[];
  /** By the name of the field. */
  readonly differences?: readonly (readonly [name: string, cause: Cause])[];
}

export const bytes = (text: string): Uint8Array =>
  text.startsWith(':') ? Uint8Array.from(text, (character) => character.charCodeAt(0)) : fromHex(text)!;

export function compared({ mine, theirs, context = {} }: Case): Comparison {
  const { transport = 'rtu', direction = 'request', request } = context;
  return compareFrames(bytes(mine), bytes(theirs), {
    transport,
    direction,
    request: request === undefined ? undefined : bytes(request),
  });
}

/** What a comparison says, in the form of a case. */
export const said = ({ causes, differences }: Comparison) => ({
  causes,
  differences: differences.map(({ mine, theirs, cause }) => [mine?.name ?? theirs?.name, cause]),
});
