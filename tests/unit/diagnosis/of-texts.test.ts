import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { diagnose, type Finding, type FindingCode, readConversation } from '../../../src/diagnosis/index.ts';
import { readBytes } from '../../../src/notation/index.ts';
import { userFrames } from './findings.ts';

const vectors = (name: string) =>
  JSON.parse(readFileSync(new URL(`../../vectors/${name}.json`, import.meta.url), 'utf8')) as unknown;
const fieldLogs = vectors('field-logs') as readonly { readonly id: string; readonly text: string }[];
const pasted = new Map(
  (
    vectors('user-frames') as readonly { readonly id: string; readonly pasted: string; readonly pastedIsProse?: true }[]
  ).map((frame) => [frame.id, frame]),
);

const SIDES = { tx: 'request', rx: 'response', request: 'request', response: 'response' } as const;

/** What is found first of each item of a text, with the request that it answers; and the places of the replies and their requests. */
function foundIn(text: string) {
  const { bytes, chunks } = readBytes(text);
  const items = readConversation(
    bytes,
    chunks.map(({ direction, ...chunk }) => ({ ...chunk, direction: direction && SIDES[direction] })),
  );
  const first = items.map((item): Finding | undefined => {
    const asked = item.kind === 'frame' && item.answers !== undefined ? items[item.answers] : undefined;
    const request = asked && bytes.subarray(asked.from, asked.to);
    return diagnose(bytes.subarray(item.from, item.to), { request })[0];
  });
  const pairs = items.flatMap((item, index) =>
    item.kind === 'frame' && item.answers !== undefined ? [[item.answers, index]] : [],
  );
  return { first, pairs };
}

interface Expected {
  readonly codes: readonly FindingCode[];
  readonly pairs?: readonly (readonly number[])[];
  /** Of the last item. */
  readonly like?: object;
}

const PAIR = [[0, 1]];
const EXPECTED: Readonly<Record<string, Expected>> = {
  'text-column-padded-digits': { codes: ['valid'] },
  'text-column-stand-ins': { codes: ['noise'] },
  'text-column-stand-ins-short': { codes: ['valid'] },
  'colour-code-before': { codes: ['valid'] },
  'colour-code-repeats': { codes: ['valid'] },
  'dumps-joined-tag': { codes: ['truncated', 'noise'] },
  'blocks-joined-tag': { codes: ['crc-missing', 'crc-missing'], pairs: PAIR },
  'follow-stream-offsets': {
    codes: ['valid', 'valid', 'valid', 'valid'],
    pairs: [
      [0, 1],
      [2, 3],
    ],
  },
  'text-column-gap-digits': { codes: ['valid'] },
  'strings-joined-two': { codes: ['noise', 'valid-exception'], like: { exceptionCode: 2 } },
  'escapes-with-words': { codes: ['noise'] },
  // Nothing is surer than possible: see below.
  'crc-missing-unknown-function': { codes: ['valid', 'crc-span'], pairs: PAIR, like: { confidence: 'possible' } },
  'esphome-command-sent': { codes: ['valid'] },
  'libmodbus-crc-line': { codes: ['valid', 'noise'] },
  'pymodbus-getting-frame': { codes: ['valid', 'valid'], pairs: PAIR },
  'pymodbus-old-data': { codes: ['noise'] },
  'short-piece-lost-frame': { codes: ['noise', 'noise'] },
  'short-piece-lost-buffer': { codes: ['valid', 'noise'] },
  'character-beside-byte': { codes: ['valid'] },
  'markdown-underscore-plain': { codes: ['valid'] },
  'comment-hash': { codes: ['valid', 'valid', 'valid'] },
  'comment-slashes': { codes: ['crc-missing', 'valid'], pairs: PAIR },
  'mixed-hex-decimal': { codes: ['valid', 'valid'] },
  'mixed-rx-decimal': { codes: ['valid', 'valid-exception'], pairs: PAIR, like: { exceptionCode: 2 } },
  'mac-addresses': { codes: [] },
  'byte-table': { codes: ['valid'] },
  'repeat-operator': { codes: ['mbap-length'], like: { got: 0, expected: 6 } },
  'index-and-value': { codes: ['valid', 'valid'], pairs: PAIR },
  'hex-text-odd-count': { codes: ['hex-of-ascii-frame'], like: { text: '0103090103047FFFFFFFd2674c5a' } },
  'wrong-length-direction': { codes: ['valid', 'mbap-length'], pairs: PAIR, like: { got: 6, expected: 9 } },
};

describe('from the text of a log to what is said of its frames', () => {
  it('has all of them', () => {
    expect(Object.keys(EXPECTED).sort()).toEqual(fieldLogs.map(({ id }) => id).sort());
  });

  it.each(fieldLogs)('$id', ({ id, text }) => {
    const { first, pairs } = foundIn(text);
    const expected = EXPECTED[id]!;
    expect(first.map((finding) => finding?.code)).toEqual(expected.codes);
    expect(pairs).toEqual(expected.pairs ?? []);
    if (expected.like) expect(first.at(-1)).toMatchObject(expected.like);
  });

  it('counts what is missing of a frame by itself, not by the dump behind it', () => {
    const { text } = fieldLogs.find(({ id }) => id === 'dumps-joined-tag')!;
    expect(foundIn(text).first[0]).toMatchObject({ code: 'truncated', has: 8, missing: 59 });
  });
});

describe('from the text that a user pasted to what is said of the frame', () => {
  const frames = userFrames.filter(({ id }) => pasted.get(id)?.pastedIsProse !== true);
  it.each(frames.map((frame) => [frame.id, frame] as const))('%s', (id, { hex, finding, transport, answering }) => {
    const { bytes } = readBytes(pasted.get(id)!.pasted);
    const request = answering && /^[\dA-F ]+$/i.test(answering) ? readBytes(answering).bytes : undefined;
    expect(bytes).toEqual(readBytes(hex, 'hex').bytes);
    const known = { transport: transport === 'data' ? undefined : transport, request };
    expect(diagnose(bytes, known)[0]?.code).toBe(finding);
  });
});
