import {
  decodeFrame,
  encodeFrame,
  type FieldKind,
  FrameError,
  fromHex,
  type Reading,
  type Transport,
  toHex,
} from '../../modbus/index.ts';
import { formatBytes } from '../../notation/index.ts';
import { characters } from './characters.ts';
import { type Draft, transports } from './draft.ts';
import { type Evaluation, evaluate, requestOf } from './evaluate.ts';

type Frame = NonNullable<Evaluation['frame']>;

/** The same frame as a transport carries it. */
export interface CarriedFrame {
  readonly transport: Transport;
  readonly draft: Draft;
  /** `undefined` if the transport cannot carry it: a forced value has no place there. */
  readonly frame: Frame | undefined;
  /** As it is copied: hexadecimal pairs, in ASCII the characters without CR LF. */
  readonly text: string;
}

/** A field as each transport carries it, in the order of `CarriedFrames.frames`; `undefined` if a frame lacks it. */
export interface CarriedField {
  readonly name: string;
  readonly kind: FieldKind;
  /** Whether RTU, ASCII and TCP all carry it, with the same value. */
  readonly stays: boolean;
  readonly texts: readonly (string | undefined)[];
  /** Its bytes in the current frame, if it has them. */
  readonly from: number | undefined;
  readonly to: number | undefined;
}

/** One frame in every transport, aligned by field. */
export interface CarriedFrames {
  readonly frames: readonly CarriedFrame[];
  readonly fields: readonly CarriedField[];
}

/** The frame of a draft in RTU, ASCII, TCP and as a bare PDU, with what changes and what stays. */
export function inEveryTransport(draft: Draft, frame: Frame): CarriedFrames {
  const frames = transports.map((transport): CarriedFrame => {
    const carried = draftIn(draft, transport);
    const made = transport === draft.transport ? frame : evaluate(carried).frame;
    return { transport, draft: carried, frame: made, text: made ? frameText(made) : '' };
  });
  return { frames, fields: namesOf(frames).map((name) => fieldOf(name, frames, draft.transport)) };
}

/** What belongs to a transport alone: a value forced there says nothing of another. */
const ENVELOPE: ReadonlySet<string> = new Set([
  'checksum',
  'protocolId',
  'length',
  'start',
  'end',
  'characters',
  'after',
]);

function draftIn(draft: Draft, transport: Transport): Draft {
  if (transport === draft.transport) return draft;
  const force = Object.fromEntries(Object.entries(draft.force).filter(([name]) => !ENVELOPE.has(name)));
  const { partner: _partner, ...alone } = draft;
  const request = requestOf(draft);
  const answering = request ? formatBytes(carriedIn(request, draft.transport, transport)) : '';
  return { ...alone, transport, force, answering };
}

/** A request in another transport; empty if that cannot carry it. */
function carriedIn(bytes: Uint8Array, from: Transport, to: Transport): Uint8Array {
  const reading = decodeFrame(bytes, { transport: from, direction: 'request' });
  const force = Object.fromEntries(Object.entries(reading.forced).filter(([name]) => !ENVELOPE.has(name)));
  try {
    const { unitId = 1, transactionId = 1 } = reading;
    return encodeFrame({ ...reading, unitId, transactionId, transport: to, force });
  } catch (error) {
    if (error instanceof FrameError) return new Uint8Array();
    throw error;
  }
}

const frameText = ({ reading, bytes }: Frame): string =>
  reading.transport === 'ascii' ? String.fromCharCode(...bytes).replace(/[\r\n]+$/, '') : formatBytes(bytes);

/** The names of the fields of all frames, each after the one that it follows. */
function namesOf(frames: readonly CarriedFrame[]): string[] {
  const names: string[] = [];
  for (const { frame } of frames) {
    let at = 0;
    for (const { name } of frame?.reading.spans ?? []) {
      const known = names.indexOf(name);
      if (known < 0) names.splice(at, 0, name);
      at = (known < 0 ? at : known) + 1;
    }
  }
  return names;
}

function fieldOf(name: string, frames: readonly CarriedFrame[], current: Transport): CarriedField {
  const found = frames.map(({ frame }) => frame?.reading.spans.find((span) => span.name === name));
  const own = found[frames.findIndex(({ transport }) => transport === current)];
  const values = frames
    .filter(({ transport }) => transport !== 'pdu')
    .map(({ frame }) => (frame ? bytesOf(frame.reading, frame.bytes, name) : undefined));
  return {
    name,
    kind: found.find((span) => span)?.kind ?? 'envelope',
    stays: values.every((value) => value !== undefined && value === values[0]),
    texts: frames.map(({ frame }, index) => {
      const span = found[index];
      return frame && span && shortText(frame, frame.bytes.subarray(span.from, span.to));
    }),
    from: own?.from,
    to: own?.to,
  };
}

/** The bytes of a field in hexadecimal, also where characters carry them; `undefined` if it has none. */
function bytesOf(reading: Reading, bytes: Uint8Array, name: string): string | undefined {
  const span = reading.spans.find((each) => each.name === name);
  if (span === undefined) return undefined;
  const slice = bytes.subarray(span.from, span.to);
  const carried = reading.transport === 'ascii' ? fromHex(String.fromCharCode(...slice)) : slice;
  return carried && toHex(carried);
}

/** Longest field that is written whole, in bytes. */
const WHOLE = 4;

function shortText({ reading }: Frame, bytes: Uint8Array): string {
  const isAscii = reading.transport === 'ascii';
  const most = isAscii ? 2 * WHOLE : WHOLE;
  const head = bytes.subarray(0, most);
  return `${isAscii ? characters(head) : formatBytes(head)}${bytes.length > most ? ' …' : ''}`;
}
