import { type Signal, signal } from '@preact/signals-core';
import type { JobNews, Wanted } from '../bus/index.ts';
import { countsValues, deviceUnit, type FoundRegister, type Profile } from '../devices/index.ts';
import {
  failureOf,
  type PollSettings,
  type ReadCell,
  type ReadCells,
  type ReadingProgress,
  readableValues,
  readKey,
  wantedValues,
} from '../workbench/index.ts';
import type { Bus } from './bus.ts';
import { Job, type JobHost } from './job.ts';

/** What was read of the map of a device: the cells are the same object while it is of that device, and grow. */
interface ReadMap {
  /** The device's id. */
  readonly of: string;
  readonly unit: number;
  readonly cells: ReadCells;
}

const NOTHING: ReadMap = { of: '', unit: 0, cells: new Map() };

/** Reads the registers of a map once, and holds what they had. */
export class MapReading extends Job {
  /** Another object after each reply. */
  readonly map: Signal<ReadMap> = signal(NOTHING);
  readonly progress: Signal<ReadingProgress | undefined> = signal(undefined);
  /** The units that somebody has chosen, by the id of the device. */
  readonly #units: Signal<Readonly<Record<string, number>>> = signal({});
  readonly #bus: JobHost & Pick<Bus, 'rules'>;
  readonly #settings: { readonly value: PollSettings };
  #cells = new Map<string, ReadCell>();
  #wanted: readonly Wanted[] = [];
  #count = 0;

  /** Requests are as large as the settings of the poll allow. */
  constructor(bus: JobHost & Pick<Bus, 'rules'>, settings: { readonly value: PollSettings }) {
    super('read', bus);
    this.#bus = bus;
    this.#settings = settings;
  }

  /** The unit that is asked: the one chosen, or that of the device, or that of the poll. */
  unitOf(profile: Profile): number {
    return this.#units.value[profile.id] ?? deviceUnit(profile) ?? this.#settings.value.unit;
  }

  chooseUnit({ id }: Profile, unit: number): void {
    this.#units.value = { ...this.#units.value, [id]: unit };
  }

  /** The most addresses between two registers that are read as well. */
  gapFor(profile: Profile): number {
    // What is between values that a device counts in its own way has a size that nobody knows.
    return countsValues(profile) ? 0 : this.#settings.value.gap;
  }

  /** Reads those of the lines that can be read. What was read of the same device before stays until it is read again. */
  start(profile: Profile, found: readonly FoundRegister[]): void {
    if (this.running.value) return;
    const unit = this.unitOf(profile);
    const { of, unit: before } = this.map.value;
    if (of !== profile.id || before !== unit) this.#cells = new Map();
    const { registers, bits } = this.#settings.value;
    const { transport } = this.#bus.rules.value;
    const values = readableValues(found);
    this.#wanted = wantedValues(profile, values, unit).wanted;
    this.#count = values.length;
    this.map.value = { of: profile.id, unit, cells: this.#cells };
    this.progress.value = { done: 0, left: 0, read: 0, failed: 0, wanted: values.length };
    const rules = { registers, bits, gap: this.gapFor(profile) };
    this.begin({ kind: 'read', transport, wanted: this.#wanted, rules }, transport);
  }

  /** What was read is that of another profile of the same device, such as the copy in which it is edited. */
  follow(before: Profile, after: Profile): void {
    if (this.map.value.of !== before.id) return;
    this.chooseUnit(after, this.map.value.unit);
    this.map.value = { ...this.map.value, of: after.id };
  }

  protected take(all: readonly JobNews[]): void {
    const { value } = this.progress;
    if (value === undefined) return;
    let { done, left, read, failed } = value;
    for (const news of all) {
      if (news.kind !== 'read') continue;
      const { time } = news;
      for (const { index, items } of news.values) {
        const wanted = this.#wanted[index];
        if (wanted === undefined) continue;
        const failure = items ? undefined : failureOf(news);
        this.#cells.set(readKey(wanted), { time, items, failure });
        // A scale register that is only read for others is no value of the map.
        if (index < this.#count) items ? read++ : failed++;
      }
      done++;
      left = news.left;
    }
    this.progress.value = { ...value, done, left, read, failed };
    this.map.value = { ...this.map.value };
  }
}
