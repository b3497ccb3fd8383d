import { decodeFrame, type Reading } from '../../modbus/index.ts';
import { type Draft, withForce } from './draft.ts';
import { draftOf } from './draft-of-reading.ts';
import { requestOf } from './evaluate.ts';

/** A frame and the draft it comes from. */
interface EditedFrame {
  readonly reading: Reading;
  readonly bytes: Uint8Array;
}

/**
 * The draft with the byte at `at` changed. A checksum that was calculated is calculated again, unless it is the byte changed:
 * then the frame has the checksum as typed. Fields that say the same keep their texts.
 */
export function withByte(draft: Draft, { reading, bytes }: EditedFrame, at: number, value: number): Draft {
  if (bytes[at] === value) return draft;
  const changed = bytes.with(at, value);
  const request = requestOf(draft);
  const { transport, direction } = reading;
  const next = draftOf(decodeFrame(changed, { transport, direction, request }), request);
  const before = draftOf(reading, request).texts;
  const texts = Object.entries(next.texts).map(([path, text]) => [
    path,
    text === before[path] ? (draft.texts[path] ?? text) : text,
  ]);
  const inChecksum = reading.spans.some(({ kind, from, to }) => kind === 'checksum' && from <= at && at < to);
  const kept = { ...draft, ...next, texts: Object.fromEntries(texts), answering: draft.answering, bytes: undefined };
  return inChecksum || reading.forced['checksum'] !== undefined ? kept : withForce(kept, 'checksum', undefined);
}

/** The byte that was typed in place: one or two hexadecimal digits, in ASCII also a character; `undefined` for anything else. */
export function typedByte(text: string, transport: Reading['transport']): number | undefined {
  if (transport === 'ascii' && text.length === 1) return text.charCodeAt(0) <= 0x7f ? text.charCodeAt(0) : undefined;
  return /^[\dA-Fa-f]{1,2}$/.test(text) ? Number.parseInt(text, 16) : undefined;
}
