import { computed, effect, type ReadonlySignal, untracked } from '@preact/signals-core';
import type { SerialLine } from '../modbus/index.ts';
import { type DeviceLine, firstLine, type LineMemory, lineFor, lineOf, storedLine } from '../workbench/index.ts';
import { same, steady } from './steady.ts';
import { KeptChoice, type PageStorage } from './storage.ts';

/** A device that has a line of its own. */
export interface OwnLine {
  readonly name: string;
  readonly serial: SerialLine;
}

/** The page whose frame's link names the line. */
interface LinePage {
  readonly line: ReadonlySignal<SerialLine | undefined>;
  readonly setLine: (line: SerialLine) => void;
}

/** The one setting of the serial line: frames are drawn and timed on it, and ports are opened with it. A tab's is its own. */
export class Line {
  /** How the line is set: as the chosen device has it until something is set by hand or the line is in use. */
  readonly setting: ReadonlySignal<SerialLine>;
  /** The chosen device with its own line, if it has one. */
  readonly own: ReadonlySignal<OwnLine | undefined>;
  /** Whether the line is set as the chosen device has it. */
  readonly isOwn = computed(() => this.own.value !== undefined && same(this.own.value.serial, this.setting.value));
  readonly #kept: KeptChoice<LineMemory>;
  readonly #page: LinePage;
  readonly #device: ReadonlySignal<DeviceLine | undefined>;

  /**
   * The frame's link has the line that is set by hand, and sets it where it is opened. `connected` tells whether the line is in
   * use: another device does not change it then.
   */
  constructor(
    page: LinePage,
    storage: PageStorage,
    device: ReadonlySignal<DeviceLine | undefined>,
    connected: ReadonlySignal<boolean>,
  ) {
    this.#kept = new KeptChoice(storage, 'line', firstLine, storedLine, 'tab');
    this.#page = page;
    this.#device = device;
    this.setting = steady(() => lineFor(this.#kept.value, connected.value ? undefined : device.value));
    this.own = steady(() => {
      const chosen = device.value;
      return chosen?.serial && { name: chosen.name, serial: lineOf(chosen.serial) };
    });
    effect(() => {
      const linked = page.line.value;
      untracked(() => {
        if (linked && !connected.value && !same(linked, this.setting.value)) this.#keep(linked);
      });
    });
    effect(() => {
      const setting = this.setting.value;
      untracked(() => {
        if (page.line.value && !same(page.line.value, setting)) page.setLine(setting);
      });
    });
  }

  /** Sets something of the line by hand; the device that is chosen now changes it no more. */
  readonly set = (changed: Partial<SerialLine>, device?: string): void => {
    this.#keep(changed, device);
    this.#page.setLine(this.setting.peek());
  };

  /** Sets the line as the chosen device has it. */
  readonly useOwn = (): void => this.set(this.own.peek()?.serial ?? {});

  /** The setting that a port is opened with. It is kept from now on, whatever device is chosen meanwhile. */
  readonly use = (): SerialLine => {
    this.#keep({});
    return this.setting.peek();
  };

  #keep(changed: Partial<SerialLine>, device = this.#device.peek()?.id ?? ''): void {
    this.#kept.value = { ...this.setting.peek(), ...changed, device };
  }
}
