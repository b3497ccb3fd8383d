/** Bytes that came beside the replies, and answer no request that waits. */
export const besides = [
  /** The request, as the adapter hears itself. */
  'echo',
  /** The reply to a request that was given up. */
  'late',
  /** A frame that came a short time before, again. */
  'copy',
  /** Another frame, such as the reply of a device that was not asked. */
  'other',
  /** Not a frame. */
  'noise',
] as const;
export type Beside = (typeof besides)[number];

/** How a request went, as the one who has sent it knows. */
export const outcomes = [
  /** Carried out: what came is the reply to it, or none was due. */
  'sure',
  /** Answered, and something about the reply is unsure. */
  'doubtful',
  /** Not answered in time: nobody waits for the reply any longer. */
  'silent',
  /** Not answered, as might have been: it asked whether somebody is there. */
  'absent',
  /** Given up before a reply was due. */
  'ended',
] as const;
export type Outcome = (typeof outcomes)[number];

/** Why a piece of a text or a file is in no frame. */
export const reasons = [
  /** Its bytes make no frame. */
  'no-frame',
  'not-a-byte',
  'value-over-255',
  'odd-digits',
  'not-of-base',
  'character-unknown',
  'escape-unknown',
  /** The text leaves bytes out. */
  'left-out',
] as const;
export type Reason = (typeof reasons)[number];

/** What the source of a record knows better than its bytes: nothing else is derived then. */
export interface Known {
  readonly beside?: Beside | undefined;
  /** Of a request. */
  readonly outcome?: Outcome | undefined;
  /** Of noise in a text or a file: why it is in no frame, its words if they are not bytes, and its line, from 1. */
  readonly why?: Reason | undefined;
  readonly text?: string | undefined;
  readonly line?: number | undefined;
}

/** One for all that know the same: a message in which they stand has it once. */
const byKind = new Map<unknown, Known>(besides.map((beside) => [beside, Object.freeze({ beside })]));
const byVerdict = new Map<unknown, Known>(
  (
    [
      ['good', 'sure'],
      ['refused', 'sure'],
      ['bad', 'sure'],
      ['doubtful', 'doubtful'],
      ['silent', 'silent'],
      ['absent', 'absent'],
      ['ended', 'ended'],
    ] as const
  ).map(([verdict, outcome]) => [verdict, Object.freeze({ outcome })]),
);

/** What a line of the bus's log knows by its kind, and of a request by its verdict; `undefined` if its bytes say as much. */
export const knownOf = (kind: unknown, verdict: unknown): Known | undefined =>
  byKind.get(kind) ?? (kind === 'request' ? byVerdict.get(verdict) : undefined);

/** What was told of a record, by anybody: `undefined` for what is not known here. */
export function readKnown(value: unknown): Known | undefined {
  if (typeof value !== 'object' || value === null) return undefined;
  const said = value as Readonly<Record<string, unknown>>;
  const beside = besides.find((one) => one === said['beside']);
  const outcome = outcomes.find((one) => one === said['outcome']);
  if (beside === undefined) return outcome && { outcome };
  if (beside !== 'noise') return { beside };
  const why = reasons.find((one) => one === said['why']);
  const { text, line } = said;
  return {
    beside,
    ...(why && { why }),
    ...(typeof text === 'string' && { text }),
    ...(typeof line === 'number' && { line }),
  };
}

/** Whether more is known than a number says. */
export const isTold = (known: Known | undefined): known is Known =>
  known !== undefined && (known.why ?? known.text ?? known.line) !== undefined;

const NOT_KNOWN = 0;
/** All that can be known, by the number that stands for it. */
const allKnown: readonly (Known | undefined)[] = [undefined, ...besides].flatMap((beside) =>
  [undefined, ...outcomes].map((outcome) =>
    beside || outcome ? Object.freeze({ ...(beside && { beside }), ...(outcome && { outcome }) }) : undefined,
  ),
);

/** A number for what is known, 0 for nothing. */
export function numberOfKnown(known: Known | undefined): number {
  if (known === undefined) return NOT_KNOWN;
  const beside = known.beside === undefined ? 0 : besides.indexOf(known.beside) + 1;
  const outcome = known.outcome === undefined ? 0 : outcomes.indexOf(known.outcome) + 1;
  return beside * (outcomes.length + 1) + outcome;
}

export const knownOfNumber = (number: number): Known | undefined => allKnown[number];
