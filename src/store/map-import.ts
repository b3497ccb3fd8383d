import { computed, type ReadonlySignal, type Signal, signal } from '@preact/signals-core';
import {
  type MapQuestion,
  type Profile,
  questionCodes,
  type RegisterMapReading,
  readMapsOf,
  readSheets,
  type SheetRow,
} from '../devices/index.ts';
import { isSameMap, type MapImportWay, mergeProfile, type Refusal } from '../workbench/index.ts';
import type { Devices } from './devices.ts';

/** A file or a text that is to become a profile. */
export interface MapSource {
  readonly name: string;
  readonly content: Uint8Array | string;
}

/** Bytes of a file of which nobody makes a register map. */
export const LARGEST_MAP = 50_000_000;

/** What an import does to the devices of a person. */
export type DeviceDesk = Pick<Devices, 'own' | 'add' | 'keep' | 'choose'>;

/** What became of a map that asked nothing: it is kept, or was here already, unchanged; `wanted` is its name in the file. */
export interface TakenMap {
  readonly kind: 'kept' | 'here';
  readonly profile: Profile;
  readonly wanted: string;
}

/** Notices of what was left alone rightly. */
const HARMLESS: ReadonlySet<string> = new Set(['heading', 'unused']);

/** Rows of the file that are shown beside what its columns are taken for. */
const SHOWN_ROWS = 7;

/** The import of a register map: the file, what a person answered, and what comes of both. A file of several maps is taken one by one. */
export class MapImport {
  readonly source: Signal<MapSource | undefined> = signal(undefined);
  /** By the code of their question; `column-2` is the meaning of the second column. */
  readonly answers: Signal<Readonly<Record<string, string>>> = signal({});
  /** Which of its maps is looked at. */
  readonly #at: Signal<number> = signal(0);
  /** The tables of the file, which no answer changes. */
  readonly #sheets = computed(() => {
    const { value: source } = this.source;
    return source && readSheets(source.content, source.name);
  });
  readonly #readings = computed((): readonly RegisterMapReading[] => {
    const { value: sheets } = this.#sheets;
    return sheets ? readMapsOf(sheets, { name: this.source.value?.name ?? '', answers: this.answers.value }) : [];
  });
  readonly reading: ReadonlySignal<RegisterMapReading | undefined> = computed(
    () => this.#readings.value[this.#at.value],
  );
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
  /** The first rows of the table, or of the first one in the file. */
  readonly rows: ReadonlySignal<readonly SheetRow[]> = computed(
    () => this.#sheets.value?.sheets[this.#at.value]?.rows.slice(0, SHOWN_ROWS) ?? [],
  );
  /** The profile of one's own that this file was imported into before, or that has its name. */
  readonly known: ReadonlySignal<Profile | undefined> = computed(() => {
    const name = this.reading.value?.profile.name;
    return this.#devices.own.value.find((own) => own.name === name);
  });
  readonly #devices: DeviceDesk;
  /** The questions that were answered: a reading that has their answers asks them no more. */
  readonly #answered: Signal<readonly MapQuestion[]> = signal([]);

  constructor(devices: DeviceDesk) {
    this.#devices = devices;
  }

  /** Opens a file. What was answered for a profile of its name stands. */
  readonly open = (source: MapSource): void => {
    this.close();
    this.source.value = source;
    this.#recall();
  };

  /**
   * Opens a file, and keeps at once what of it leaves nothing to ask or to tell. What does stays open: then the last of its maps
   * is not among those that were taken.
   */
  readonly take = (source: MapSource): readonly TakenMap[] | Refusal => {
    this.open(source);
    const taken: TakenMap[] = [];
    for (let reading = this.reading.peek(); reading && this.#isClear(reading); reading = this.reading.peek()) {
      const { profile } = reading;
      const same = this.#devices.own.peek().find((own) => isSameMap(own, profile));
      const kept = same ?? this.#devices.add(profile);
      if (typeof kept === 'string') {
        this.close();
        return kept;
      }
      if (same) this.#devices.choose(same.id);
      taken.push({ kind: same ? 'here' : 'kept', profile: kept, wanted: profile.name });
      this.#goOn();
    }
    return taken;
  };

  /** Nothing is asked, lost or doubtful, and no other profile has the name of this one. Of ours one without registers counts, too. */
  #isClear({ profile, questions, faults, notices }: RegisterMapReading): boolean {
    const known = this.known.peek();
    return (
      (profile.registers.length > 0 || profile.id !== '') &&
      questions.length === 0 &&
      faults.length === 0 &&
      notices.every(({ code }) => HARMLESS.has(code)) &&
      (known === undefined || isSameMap(known, profile))
    );
  }

  /** Goes to the next map of the file, or ends the import after the last one. */
  #goOn(): void {
    const next = this.#at.peek() + 1;
    if (next >= this.#readings.peek().length) {
      this.close();
      return;
    }
    this.#at.value = next;
    this.answers.value = {};
    this.#answered.value = [];
    this.#recall();
  }

  #recall(): void {
    const kept = this.known.peek()?.answers;
    if (!kept) return;
    this.#answered.value = (this.reading.peek()?.questions ?? []).filter(({ code }) => Object.hasOwn(kept, code));
    this.answers.value = kept;
  }

  readonly answer = (code: string, option: string): void => {
    const question = this.reading.peek()?.questions.find((each) => each.code === code);
    if (question) this.#answered.value = [...this.#answered.peek(), question];
    this.answers.value = { ...this.answers.peek(), [code]: option };
  };

  readonly close = (): void => {
    this.source.value = undefined;
    this.#at.value = 0;
    this.answers.value = {};
    this.#answered.value = [];
  };

  /** Keeps what was read as a profile of one's own, chooses it, and goes on to the next one of the file. */
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
    this.#goOn();
    return 'kind' in kept ? known : kept;
  };
}
