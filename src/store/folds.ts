import { signal } from '@preact/signals-core';
import { flag } from '../workbench/index.ts';
import { KeptChoice, type PageStorage } from './storage.ts';

/** Which panels of the Frame view are unfolded. The comparison is folded again after a reload, when it is empty. */
export class Folds {
  readonly values: KeptChoice<boolean>;
  readonly wire: KeptChoice<boolean>;
  readonly compare = signal(false);

  constructor(storage: PageStorage) {
    this.values = new KeptChoice(storage, 'values', true, flag);
    this.wire = new KeptChoice(storage, 'wire', false, flag);
  }
}
