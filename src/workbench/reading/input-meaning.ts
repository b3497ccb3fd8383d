import type { Table } from '../../modbus/index.ts';
import type { Draft } from '../frame/draft.ts';
import type { TextReading } from './read-text.ts';

/** One thing that a text may be, and the draft that it comes to. */
export type InputOffer =
  /** The function of this code; `name` is the specification's. */
  | { readonly as: 'function'; readonly code: number; readonly name: string; readonly draft: Draft }
  | { readonly as: 'bytes'; readonly bytes: Uint8Array; readonly draft: Draft }
  /** Registers of a reply. */
  | { readonly as: 'values'; readonly registers: readonly number[]; readonly draft: Draft }
  | {
      readonly as: 'address';
      readonly table: Table;
      /** Counted from 0. */
      readonly address: number;
      /** What the device calls it, and the device's name. */
      readonly name?: string;
      readonly device?: string;
      readonly draft: Draft;
    };

/**
 * What the text of the input was taken for. `others` are what it may be besides; of `bare-numbers` none was taken, and the frame
 * stays as it is until one is.
 */
export type InputMeaning =
  | { readonly kind: 'empty' }
  | { readonly kind: 'frames'; readonly reading: TextReading }
  | { readonly kind: 'address'; readonly taken: InputOffer; readonly others: readonly InputOffer[] }
  | { readonly kind: 'function'; readonly taken: InputOffer; readonly others: readonly InputOffer[] }
  /** A value for the register in the frame, or for the one that the text names. */
  | { readonly kind: 'value-with-unit'; readonly draft: Draft; readonly others: readonly InputOffer[] }
  | { readonly kind: 'bare-numbers'; readonly offers: readonly InputOffer[] }
  | { readonly kind: 'no-bytes'; readonly reading: TextReading };

/** What a text means beside the frame that is there. */
export interface InputContext {
  readonly draft: Draft;
}

/** What a text that was read is taken for. */
export function inputMeaning(reading: TextReading, _context: InputContext): InputMeaning {
  if (reading.text.trim() === '') return { kind: 'empty' };
  return { kind: reading.bytes.length === 0 ? 'no-bytes' : 'frames', reading };
}

/** The draft that a meaning comes to; `undefined` if the frames decide, or nothing is taken. */
export function draftMeant(meaning: InputMeaning): Draft | undefined {
  switch (meaning.kind) {
    case 'address':
    case 'function':
      return meaning.taken.draft;
    case 'value-with-unit':
      return meaning.draft;
    default:
      return undefined;
  }
}
