import { type ConversationItem, readConversation } from '../../diagnosis/index.ts';
import { type ByteNotation, readBytes, type TextProblem } from '../../notation/index.ts';

/** A frame of the text, or bytes in none, with what the text says of it: whether it was received. */
export type PastedItem = ConversationItem & { readonly said: 'request' | 'response' | undefined };

/** A text as read. */
export interface TextReading {
  readonly text: string;
  readonly bytes: Uint8Array;
  /** For byte `n`, its start and end in the text at `2n` and `2n + 1`. */
  readonly origin: Uint32Array;
  readonly notation: ByteNotation;
  readonly alternatives: readonly { readonly reading: ByteNotation; readonly bytes: Uint8Array }[];
  /** The notes come last, so that they hide nothing. */
  readonly problems: readonly TextProblem[];
  readonly problemCount: number;
  /** The frames, and the bytes that are in none, in order. */
  readonly items: readonly PastedItem[];
}

/** Most logs are those of a client, which sends requests; where they are a server's, the frames themselves tell. */
const DIRECTIONS = { request: 'request', response: 'response', tx: 'request', rx: 'response' } as const;

/** What is said of a text without anything being wrong. */
const NOTES: ReadonlySet<TextProblem['code']> = new Set(['left-out', 'set-aside', 'checksum-said']);
export const isTextNote = ({ code }: TextProblem): boolean => NOTES.has(code);

/** More problems than this are counted only. */
const PROBLEMS_KEPT = 200;

/** Reads a text and finds its frames. */
export function readText(text: string, as: ByteNotation | undefined): TextReading {
  const { bytes, origin, reading, alternatives, problems, chunks } = readBytes(text, as);
  const places = new Uint32Array(2 * origin.length);
  origin.forEach(({ start, end }, index) => {
    places[2 * index] = start;
    places[2 * index + 1] = end;
  });
  const hinted = chunks.map(({ from, to, direction, transport }) => ({
    from,
    to,
    transport,
    direction: direction && DIRECTIONS[direction],
  }));
  let chunk = 0;
  const items = readConversation(bytes, hinted).map((item) => {
    while (chunk + 1 < chunks.length && (chunks[chunk]?.to ?? 0) <= item.from) chunk++;
    return { ...item, said: hinted[chunk]?.direction };
  });
  return {
    text,
    bytes,
    origin: places,
    notation: reading,
    alternatives: alternatives.map((other) => ({ reading: other.reading, bytes: other.bytes })),
    problems: [...problems.filter((one) => !isTextNote(one)), ...problems.filter(isTextNote)].slice(0, PROBLEMS_KEPT),
    problemCount: problems.length,
    items,
  };
}
