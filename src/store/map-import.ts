import { computed, type ReadonlySignal, type Signal, signal } from '@preact/signals-core';
import {
  type MapQuestion,
  type Profile,
  questionCodes,
  type RegisterMapReading,
  type SheetRow,
} from '../devices/index.ts';
import {
  isSameMap,
  type MapAnswers,
  type MapImportWay,
  type MapSource,
  mergeProfile,
  type ReadMaps,
  type Refusal,
} from '../workbench/index.ts';
import type { Devices } from './devices.ts';

/** What reads maps beside the page. */
export interface MapReader {
  open(source: MapSource): OpenMap;
}

/** A file that is read with any answers. */
export interface OpenMap {
  /** `undefined` if it cannot be read, or is closed meanwhile. */
  read(answers: MapAnswers): Promise<ReadMaps | undefined>;
  close(): void;
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

/** The import of a register map: the file, what a person answered, and what comes of both. A file of several maps is taken one by one. */
export class MapImport {
  readonly source: Signal<MapSource | undefined> = signal(undefined);
  readonly answers: Signal<MapAnswers> = signal({});
  /** Which of its maps is looked at. */
  readonly #at: Signal<number> = signal(0);
  readonly #read: Signal<ReadMaps | undefined> = signal(undefined);
  #open: OpenMap | undefined;
  /** Ends when what is read says all answers. */
  #settled: Promise<void> = Promise.resolve();
  readonly reading: ReadonlySignal<RegisterMapReading | undefined> = computed(
    () => this.#read.value?.readings[this.#at.value],
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
  readonly rows: ReadonlySignal<readonly SheetRow[]> = computed(() => this.#read.value?.rows[this.#at.value] ?? []);
  /** The profile of one's own that this file was imported into before, or that has its name. */
  readonly known: ReadonlySignal<Profile | undefined> = computed(() => {
    const name = this.reading.value?.profile.name;
    return this.#devices.own.value.find((own) => own.name === name);
  });
  readonly #devices: DeviceDesk;
  readonly #reader: MapReader;
  /** The questions that were answered: a reading that has their answers asks them no more. */
  readonly #answered: Signal<readonly MapQuestion[]> = signal([]);

  constructor(devices: DeviceDesk, reader: MapReader) {
    this.#devices = devices;
    this.#reader = reader;
  }

  /** Opens a file. What was answered for a profile of its name stands. Answers whether it could be read. */
  readonly open = async (source: MapSource): Promise<boolean> => {
    this.close();
    this.source.value = source;
    const open = this.#reader.open(source);
    this.#open = open;
    await this.#readAgain();
    await this.#recall();
    // Another one that was opened meanwhile has taken its place.
    if (this.#open === open && this.#read.peek() === undefined) this.close();
    return this.#open !== undefined;
  };

  /**
   * Opens a file, and keeps at once what of it leaves nothing to ask or to tell. What does stays open: then the last of its maps
   * is not among those that were taken.
   */
  readonly take = async (source: MapSource): Promise<readonly TakenMap[] | Refusal | 'unread'> => {
    if (!(await this.open(source))) return 'unread';
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
      await this.#goOn();
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
  async #goOn(): Promise<void> {
    const next = this.#at.peek() + 1;
    if (next >= (this.#read.peek()?.readings.length ?? 0)) {
      this.close();
      return;
    }
    const isAnswered = Object.keys(this.answers.peek()).length > 0;
    this.#at.value = next;
    this.answers.value = {};
    this.#answered.value = [];
    if (isAnswered) await this.#readAgain();
    await this.#recall();
  }

  async #recall(): Promise<void> {
    const kept = this.known.peek()?.answers;
    if (!kept) return;
    this.#answered.value = (this.reading.peek()?.questions ?? []).filter(({ code }) => Object.hasOwn(kept, code));
    this.answers.value = kept;
    await this.#readAgain();
  }

  /** Reads with the present answers. What is read later counts. */
  #readAgain(): Promise<void> {
    const [open, answers] = [this.#open, this.answers.peek()];
    const settled = open?.read(answers).then((read) => {
      if (open === this.#open && answers === this.answers.peek()) this.#read.value = read;
    });
    this.#settled = settled ?? Promise.resolve();
    return this.#settled;
  }

  readonly answer = (code: string, option: string): void => {
    const question = this.reading.peek()?.questions.find((each) => each.code === code);
    if (question) this.#answered.value = [...this.#answered.peek(), question];
    this.answers.value = { ...this.answers.peek(), [code]: option };
    void this.#readAgain();
  };

  readonly close = (): void => {
    this.#open?.close();
    this.#open = undefined;
    this.#read.value = undefined;
    this.source.value = undefined;
    this.#at.value = 0;
    this.answers.value = {};
    this.#answered.value = [];
  };

  /** Keeps what was read as a profile of one's own, chooses it, and goes on to the next one of the file. */
  readonly keep = async (way: MapImportWay): Promise<Profile | Refusal> => {
    await this.#settled;
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
    await this.#goOn();
    return 'kind' in kept ? (known ?? 'gone') : kept;
  };
}
