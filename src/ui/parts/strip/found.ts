import { signal } from '@preact/signals';
import type { Finding } from '../../../diagnosis/index.ts';
import type { Repair } from '../../../workbench/index.ts';

/** What was found of the current frame, once it was looked into: `cause` is the best finding in one sentence. */
export interface Found {
  readonly of: Uint8Array;
  readonly findings: readonly Finding[];
  readonly cause: string;
  /** Whether there is nothing to say of it. */
  readonly sound: boolean;
  /** What is offered first. */
  readonly repair: Repair | undefined;
  /** Makes repaired bytes the current frame, as one step. */
  readonly use: (bytes: Uint8Array) => void;
}

export const found = signal<Found | undefined>(undefined);
