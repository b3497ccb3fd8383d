import { computed, type ReadonlySignal, signal } from '@preact/signals-core';
import type { Profile } from '../devices/index.ts';
import { firstScale, type ScaleTexts, scaleWithUnit, storedScale, type UnitSource } from '../workbench/index.ts';
import { KeptChoice, type PageStorage } from './storage.ts';

/** How values in registers are looked at, and those that are to be written. */
export class Values {
  /** The scale typed last, which other fields follow. */
  readonly scale: KeptChoice<ScaleTexts>;
  /** Where the units of values come from now. */
  readonly units: ReadonlySignal<UnitSource>;
  /** The register from which values are shown, counted through all lists of the frame. */
  readonly first = signal(0);
  /** The value that is looked for, as typed. */
  readonly expected = signal('');
  /** Whether types that few devices have are shown. */
  readonly rare = signal(false);
  /** Values to be written, as typed. */
  readonly typed = signal('');

  constructor(storage: PageStorage, device: ReadonlySignal<Profile | undefined>) {
    this.scale = new KeptChoice(storage, 'scale', firstScale, storedScale);
    this.units = computed(() => ({ device: device.value, own: scaleWithUnit(this.scale.value) }));
  }

  readonly setScale = (change: Partial<ScaleTexts>): void => {
    this.scale.value = { ...this.scale.value, ...change };
  };
}
