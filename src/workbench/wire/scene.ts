import {
  asciiGapEffect,
  bitsPerCharacter,
  decodeFrame,
  edgesOf,
  firstAfter,
  type Gap,
  type GapEffect,
  type Line,
  lineOf,
  type Reading,
  type ReceivedCharacter,
  type Receiver,
  receive,
  rtuGapEffect,
  rtuSilences,
  type SerialLine,
  type Silences,
  type Span,
} from '../../modbus/index.ts';
import type { Draft } from '../frame/draft.ts';
import { type Evaluation, requestOf } from '../frame/evaluate.ts';
import { expectReply } from '../frame/expected-reply.ts';

/** A frame of the exchange. */
export interface SentFrame {
  readonly bytes: Uint8Array;
  readonly reading: Reading;
  /** Whether it is the one that the form builds. */
  readonly current: boolean;
}

type Frame = NonNullable<Evaluation['frame']>;

/** The draft, and its frame. */
export interface WireProps {
  readonly draft: Draft;
  readonly frame: Frame;
}

/** The request and its reply, as far as both are known: to a request the expected one, to a reply what it answers. */
export function exchangeOf({ draft, frame }: WireProps): SentFrame[] {
  const mine = { ...frame, current: true };
  if (draft.kind === 'request') {
    const expected = expectReply(draft, frame.reading, frame.bytes);
    const reply = expected.kind === 'none' ? undefined : expected.evaluation.frame;
    return reply ? [mine, { ...reply, current: false }] : [mine];
  }
  const bytes = requestOf(draft);
  if (bytes === undefined || bytes.length === 0) return [mine];
  const reading = decodeFrame(bytes, { transport: draft.transport, direction: 'request' });
  return [{ bytes, reading, current: false }, mine];
}

/** An exchange on its line. */
export interface Scene {
  readonly line: Line;
  readonly sent: readonly SentFrame[];
  readonly serial: SerialLine;
  /** In microseconds; `undefined` in ASCII, which needs no silence. */
  readonly silences: Silences | undefined;
  /** The index of the current frame, and the pause in it. */
  readonly own: number;
  readonly gap: { readonly after: number; readonly time: number } | undefined;
  /** The field of each byte of each frame. */
  readonly fields: readonly (readonly (Span | undefined)[])[];
}

const SECOND = 1_000_000;
/** Characters of idle line that are shown at either end. */
const LEAD = 1;

/** Bit times of a time in microseconds. */
export const bitsIn = ({ baud }: SerialLine, time: number): number => (time * baud) / SECOND;

export interface SceneSettings {
  readonly serial: SerialLine;
  /** Microseconds from the end of the request to the start of the reply. */
  readonly delay: number;
  /** A pause in the current frame, in microseconds, before its byte `after`. */
  readonly gap: Scene['gap'];
}

/** Puts an exchange on its line. */
export function sceneOf(sent: readonly SentFrame[], { serial, delay, gap }: SceneSettings): Scene {
  const length = bitsPerCharacter(serial);
  const isRtu = sent[0]?.reading.transport === 'rtu';
  const silences = isRtu ? rtuSilences(serial.baud, length) : undefined;
  const bits = (time: number) => bitsIn(serial, time);
  const pause: Gap | undefined = gap && { after: gap.after, length: bits(gap.time) };
  const line = lineOf(
    sent.map(({ bytes, current }) => ({ bytes, gap: current ? pause : undefined })),
    serial,
    { lead: LEAD * length, silence: silences ? bits(silences.t35) : 2 * length, delay: bits(delay) },
  );
  const fields = sent.map(({ reading, bytes }) => {
    const of: (Span | undefined)[] = new Array(bytes.length).fill(undefined);
    for (const span of reading.spans) of.fill(span, span.from, span.to);
    return of;
  });
  return { line, sent, serial, silences, gap, own: sent.findIndex(({ current }) => current), fields };
}

/** When the first frame begins: times are counted from there. */
export const sceneOrigin = ({ line }: Scene): number => line.frames[0]?.from ?? 0;

/** A time on the line in microseconds, counted from the first frame's start. */
export const sceneTime = (scene: Scene, bits: number): number =>
  ((bits - sceneOrigin(scene)) * SECOND) / scene.serial.baud;

/** What a receiver reads of the current frame. */
export function receivedOf({ line, own }: Scene, receiver: Receiver): ReceivedCharacter[] {
  const characters = line.characters.filter(({ frame }) => frame === own);
  return receive(edgesOf({ characters, format: line.format }), receiver);
}

/** The bytes `[from, to)` of the current frame that were on the line between two times. */
export function bytesDuring({ line, own }: Scene, from: number, to: number): readonly [number, number] | undefined {
  const { characters } = line;
  let first = firstAfter(characters, from);
  while (first < characters.length && characters[first]?.frame !== own) first++;
  let end = first;
  for (let next = characters[end]; next && next.frame === own && next.start < to; next = characters[end]) end++;
  const [one, last] = [characters[first], characters[end - 1]];
  return end > first && one && last ? [one.index, last.index + 1] : undefined;
}

/** What the gap in the current frame does; `undefined` if it has no gap. */
export function gapEffectOf({ gap, silences }: Scene): GapEffect | undefined {
  if (gap === undefined) return undefined;
  return silences ? rtuGapEffect(gap.time, silences) : asciiGapEffect(gap.time);
}
