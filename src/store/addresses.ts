import { effect, type ReadonlySignal, untracked } from '@preact/signals-core';
import type { Profile } from '../devices/index.ts';
import type { Table } from '../modbus/index.ts';
import { type AddressConvention, addressConventions } from '../notation/index.ts';
import {
  type AddressContext,
  addressInFrame,
  type Draft,
  isStillRange,
  oneOf,
  type RegisterNames,
  type Shown,
  shownAt,
  withAddress,
} from '../workbench/index.ts';
import type { Page } from './page.ts';
import { KeptChoice, type PageStorage } from './storage.ts';

/** What the page knows of the device whose registers have names. */
interface Named {
  readonly device: ReadonlySignal<Profile | undefined>;
  readonly registerNames: ReadonlySignal<RegisterNames | undefined>;
}

/** Addresses as the chosen manual and the chosen device have them. */
export class Addresses {
  /** How the manual prints addresses. */
  readonly convention: KeptChoice<AddressConvention>;
  readonly #named: Named;

  /** The page is told what gives addresses their meaning. */
  constructor(page: Page, storage: PageStorage, named: Named) {
    this.convention = new KeptChoice<AddressConvention>(storage, 'addresses', 'protocol', oneOf(addressConventions));
    this.#named = named;
    effect(() => {
      const context = this.#context;
      untracked(() => {
        page.addressing.value = context;
      });
    });
  }

  /** What an address field shows. */
  readonly shown = (draft: Draft, path: string, text: string, table: Table): Shown => {
    const shown = shownAt(draft, path, text, (typed) => addressInFrame(typed, table, this.#context));
    return isStillRange(draft, path, shown.text, table, this.#context) ? shown : { text, notHere: undefined };
  };

  /** The draft with an address as it was typed; a range fills the quantity too. */
  readonly withTyped = (draft: Draft, path: string, typed: string, table: Table): Draft =>
    withAddress(draft, { path, typed, table }, this.#context, this.#named.device.value?.id);

  get #context(): AddressContext {
    return { convention: this.convention.value, names: this.#named.registerNames.value };
  }
}
