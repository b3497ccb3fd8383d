import type { Transport } from '../modbus/index.ts';
import type { Known } from './known.ts';

/** Where the bytes of a record stand: in packets of a capture (from 1), in a text, in bytes, or nowhere, as they were heard. */
export type Place =
  | { readonly kind: 'packet'; readonly numbers: readonly number[] }
  | { readonly kind: 'text'; readonly from: number; readonly to: number }
  | { readonly kind: 'bytes'; readonly from: number; readonly to: number }
  | { readonly kind: 'live' };

export type Carried = Exclude<Transport, 'pdu'>;
export type RecordSide = 'request' | 'response';

/** One frame of a conversation, or bytes that stand in the place of one. */
export interface CaptureRecord {
  /** One whole RTU frame, ASCII frame with ':' and CR LF, or TCP ADU; a view where its source has it in one piece. */
  readonly bytes: Uint8Array;
  /** Microseconds since 1970, or since the first record where the source knows no date. */
  readonly time?: number | undefined;
  readonly side?: RecordSide | undefined;
  readonly transport: Carried;
  /** Who spoke to whom: `192.0.2.1:49152`, or the name of a line. */
  readonly from?: string | undefined;
  readonly to?: string | undefined;
  readonly place: Place;
  readonly known?: Known | undefined;
}

/** What a trace takes: without a transport the bytes tell it, without a place the record is a live one. */
export type TraceInput = Partial<CaptureRecord> & { readonly bytes: Uint8Array };
