import type { ReadonlySignal } from '@preact/signals-core';
import type { Profile } from '../devices/index.ts';
import type { SerialMode } from '../modbus/index.ts';
import { firstLine, type LineChoice, type LineMemory, lineChoice, storedLine, withLine } from '../workbench/index.ts';
import { KeptChoice, type PageStorage } from './storage.ts';

/** The serial line on which frames are drawn. */
export class Line {
  readonly #kept: KeptChoice<LineMemory>;
  readonly #device: ReadonlySignal<Profile | undefined>;

  constructor(storage: PageStorage, device: ReadonlySignal<Profile | undefined>) {
    this.#kept = new KeptChoice(storage, 'wire-line', firstLine, storedLine);
    this.#device = device;
  }

  /** How the line is set for the device that is chosen. */
  readonly choice = (mode: SerialMode): LineChoice => lineChoice(this.#kept.value, mode, this.#device.value);

  /** Sets something of the line, and remembers it for the device that is chosen. */
  readonly set = (mode: SerialMode, changed: Partial<Omit<LineChoice, 'device'>>): void => {
    this.#kept.value = withLine(this.#kept.value, mode, this.#device.value, changed);
  };
}
