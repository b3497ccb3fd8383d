import type { ReadonlySignal } from '@preact/signals-core';
import type { Profile } from '../devices/index.ts';
import type { Table } from '../modbus/index.ts';
import { type AddressConvention, addressConventions } from '../notation/index.ts';
import {
  addressInFrame,
  type Draft,
  oneOf,
  type RegisterNames,
  type Shown,
  shownAt,
  withTyped,
} from '../workbench/index.ts';
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

  constructor(storage: PageStorage, named: Named) {
    this.convention = new KeptChoice<AddressConvention>(storage, 'addresses', 'protocol', oneOf(addressConventions));
    this.#named = named;
  }

  /** What an address field shows. */
  readonly shown = (draft: Draft, path: string, text: string, table: Table): Shown =>
    shownAt(draft, path, text, (typed) => this.#inFrame(typed, table));

  /** The draft with an address as it was typed. */
  readonly withTyped = (draft: Draft, path: string, typed: string, table: Table): Draft =>
    withTyped(draft, path, typed, this.#inFrame(typed, table), this.#named.device.value?.id);

  /** The text that a frame's field gets for an address as typed. */
  #inFrame(typed: string, table: Table): string {
    const [convention, names] = [this.convention.value, this.#named.registerNames.value];
    return addressInFrame(typed, table, { convention, names });
  }
}
