import { signal } from '@preact/signals';
import type { Control, Draft } from '../../../workbench/index.ts';

/** What a field of registers shows and says while values of any type and unit are typed in it. */
export interface ValueAid {
  readonly typed: { readonly text: string; readonly onText: (text: string) => void };
  /** What the values come to. */
  readonly said: string | undefined;
  /** Why what was typed is not a value. */
  readonly wrong: string | undefined;
}

/** Lets values be typed into the fields that hold registers; it comes with the values. */
export const valueAid = signal<((control: Control, draft: Draft) => ValueAid | undefined) | undefined>(undefined);
