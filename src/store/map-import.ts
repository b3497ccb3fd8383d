import { computed, type ReadonlySignal, type Signal, signal } from '@preact/signals-core';
import {
  type MapQuestion,
  type Profile,
  questionCodes,
  type RegisterMapReading,
  readMapOf,
  readSheets,
  type SheetRow,
} from '../devices/index.ts';
import { type MapImportWay, mergeProfile } from '../workbench/index.ts';
import type { Devices } from './devices.ts';

/** A file or a text that is to become a profile. */
export interface MapSource {
  readonly name: string;
  readonly content: Uint8Array | string;
}

/** Rows of the file that are shown beside what its columns are taken for. */
const SHOWN_ROWS = 7;

/** The import of a register map: the file, what a person answered, and what comes of both. */
export class MapImport {
  readonly source: Signal<MapSource | undefined> = signal(undefined);
  /** By the code of their question; `column-2` is the meaning of the second column. */
  readonly answers: Signal<Readonly<Record<string, string>>> = signal({});
  /** The tables of the file, which no answer changes. */
  readonly #sheets = computed(() => {
    const { value: source } = this.source;
    return source && readSheets(source.content, source.name);
  });
  readonly reading: ReadonlySignal<RegisterMapReading | undefined> = computed(() => {
    const { value: sheets } = this.#sheets;
    return sheets && readMapOf(sheets, { name: this.source.value?.name ?? '', answers: this.answers.value });
  });
  /** What is asked, and what was answered, which can be answered otherwise, in an order that does not change. */
  readonly questions: ReadonlySignal<readonly MapQuestion[]> = computed(() => {
    const asked = this.reading.value?.questions ?? [];
    const answers = this.answers.value;
    const answered = this.#answered.value
      .filter(({ code }) => !asked.some((each) => each.code === code))
      .map((question) => ({ ...question, assumed: answers[question.code] ?? question.assumed }));
    const place = ({ code }: MapQuestion) => questionCodes.indexOf(code);
    return [...asked, ...answered].toSorted((one, other) => place(one) - place(other));
  });
  /** The first rows of the first table in the file. */
  readonly rows: ReadonlySignal<readonly SheetRow[]> = computed(
    () => this.#sheets.value?.sheets[0]?.rows.slice(0, SHOWN_ROWS) ?? [],
  );
  /** The profile of one's own that this file was imported into before, or that has its name. */
  readonly known: ReadonlySignal<Profile | undefined> = computed(() => {
    const name = this.reading.value?.profile.name;
    return this.#devices.own.value.find((own) => own.name === name);
  });
  readonly #devices: Devices;
  /** The questions that were answered: a reading that has their answers asks them no more. */
  readonly #answered: Signal<readonly MapQuestion[]> = signal([]);

  constructor(devices: Devices) {
    this.#devices = devices;
  }

  /** Opens a file. What was answered for a profile of its name stands. */
  readonly open = (source: MapSource): void => {
    this.close();
    this.source.value = source;
    const kept = this.known.peek()?.answers;
    if (!kept) return;
    this.#answered.value = (this.reading.peek()?.questions ?? []).filter(({ code }) => Object.hasOwn(kept, code));
    this.answers.value = kept;
  };

  readonly answer = (code: string, option: string): void => {
    const question = this.reading.peek()?.questions.find((each) => each.code === code);
    if (question) this.#answered.value = [...this.#answered.peek(), question];
    this.answers.value = { ...this.answers.peek(), [code]: option };
  };

  readonly close = (): void => {
    this.source.value = undefined;
    this.answers.value = {};
    this.#answered.value = [];
  };

  /** Keeps what was read as a profile of one's own, chooses it, and ends the import. */
  readonly keep = (way: MapImportWay) => {
    const reading = this.reading.peek();
    if (reading === undefined) return 'gone';
    const answers = this.answers.peek();
    const read: Profile = { ...reading.profile, ...(Object.keys(answers).length > 0 ? { answers } : {}) };
    const known = this.known.peek();
    const kept =
      known === undefined || way === 'add'
        ? this.#devices.add(read)
        : this.#devices.keep(known, way === 'replace' ? { ...read, id: known.id } : mergeProfile(known, read));
    if (typeof kept === 'string') return kept;
    if (known && way !== 'add') this.#devices.choose(known.id);
    this.close();
    return 'kind' in kept ? known : kept;
  };
}
