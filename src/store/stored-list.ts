import { type Signal, signal } from '@preact/signals-core';
import { type Kept, KeptList, type ListCodec } from '../workbench/index.ts';
import type { PageStorage } from './storage.ts';

/** A list kept under a key of its own, which other tabs may change too. */
export class StoredList<T, Fault, Bad = never> extends KeptList<T, Fault, Bad> {
  /** The list as this tab knows it. */
  readonly stored: Signal<Kept<T, Fault, Bad>>;

  constructor(storage: PageStorage, name: string, codec: ListCodec<T, Fault, Bad>) {
    super(name, codec, storage.texts);
    this.stored = signal(this.kept);
    storage.follow(this.key, () => this.reload());
  }

  protected override changed(kept: Kept<T, Fault, Bad>): void {
    this.stored.value = kept;
  }
}
