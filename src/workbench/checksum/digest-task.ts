import type { InputKind } from './checksum-input.ts';
import type { DigestedInput, ToldChecksum } from './checksum-values.ts';

/**
 * What a worker is asked for: a text or a small file with all checksums, or a part of a large file with some. `F` is a file
 * as the worker reads it.
 */
export type DigestTask<F> =
  | { readonly kind: 'text'; readonly text: string; readonly as: InputKind }
  | { readonly kind: 'file'; readonly file: F }
  | {
      readonly kind: 'part';
      readonly file: F;
      readonly first: boolean;
      readonly algorithms: readonly ToldChecksum[];
    };

export type DigestAnswer =
  | ({ readonly kind: 'whole' } & DigestedInput)
  /** Bytes read since the last message. */
  | { readonly kind: 'progress'; readonly bytes: number }
  /** The states of the checksums after the part. */
  | { readonly kind: 'part'; readonly states: readonly number[] }
  | { readonly kind: 'failed' };
