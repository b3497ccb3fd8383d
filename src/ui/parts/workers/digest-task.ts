import type { DigestedInput, InputKind, ToldChecksum } from '../../../workbench/index.ts';

/** What a worker is asked for: a text or a small file with all checksums, or a part of a large file with some. */
export type Task =
  | { readonly kind: 'text'; readonly text: string; readonly as: InputKind }
  | { readonly kind: 'file'; readonly file: Blob }
  | {
      readonly kind: 'part';
      readonly file: Blob;
      readonly first: boolean;
      readonly algorithms: readonly ToldChecksum[];
    };

export type Answer =
  | ({ readonly kind: 'whole' } & DigestedInput)
  /** Bytes read since the last message. */
  | { readonly kind: 'progress'; readonly bytes: number }
  /** The states of the checksums after the part. */
  | { readonly kind: 'part'; readonly states: readonly number[] }
  | { readonly kind: 'failed' };
