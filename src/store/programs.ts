import { computed, type ReadonlySignal, type Signal, signal } from '@preact/signals-core';
import { type ProgramPart, programTargets } from '../codegen/index.ts';
import {
  firstProgramChoice,
  firstProgramSettings,
  type ProgramChoice,
  type ProgramSettings,
  type ProgramSurroundings,
  programChoiceText,
  programOptions,
  readProgramChoice,
  storedProgramSettings,
  text,
} from '../workbench/index.ts';
import type { Page } from './page.ts';
import { KeptChoice, type PageStorage } from './storage.ts';

/** Which program is written, and how: the target and the part are in the frame's link, and all is remembered. */
export class Programs {
  readonly settings: KeptChoice<ProgramSettings>;
  /** What the request is called, as typed; it is not kept, since another request has another name. */
  readonly name: Signal<string> = signal('');
  /** The target and the part that are chosen, or else those of the last time. */
  readonly choice: ReadonlySignal<ProgramChoice>;
  /** The target that the link names, if there is no such target here. */
  readonly unknown: ReadonlySignal<string | undefined>;
  /** The options of `writeProgram`. */
  readonly options: ReadonlySignal<ReturnType<typeof programOptions>>;
  readonly #page: Page;
  readonly #remembered: KeptChoice<string>;

  constructor(page: Page, storage: PageStorage, surroundings: ReadonlySignal<ProgramSurroundings>) {
    this.#page = page;
    this.settings = new KeptChoice(storage, 'program', firstProgramSettings, storedProgramSettings);
    this.#remembered = new KeptChoice(storage, 'program-target', '', text(), 'tab');
    const linked = computed(() => readProgramChoice(page.program.value ?? ''));
    this.unknown = computed(() => {
      const { value: given } = page.program;
      return given === undefined || (linked.value && isTarget(linked.value)) ? undefined : given;
    });
    this.choice = computed(() => {
      const chosen = [linked.value, readProgramChoice(this.#remembered.value)];
      return chosen.find((choice) => choice && isTarget(choice)) ?? firstProgramChoice;
    });
    this.options = computed(() =>
      programOptions(this.choice.value.part, this.settings.value, surroundings.value, this.name.value),
    );
  }

  /** Names the program in the link, also where it is the one of the last time: whoever opens the link sees the same. */
  readonly open = (): void => {
    if (this.#page.program.peek() === undefined) this.#take(this.choice.peek());
  };

  /** Chooses a target; the part stays, so that it is there again for the next target that offers it. */
  readonly chooseTarget = (target: string): void => this.#take({ ...this.choice.peek(), target });

  readonly choosePart = (part: ProgramPart): void => this.#take({ ...this.choice.peek(), part });

  readonly set = (change: Partial<ProgramSettings>): void => {
    this.settings.value = { ...this.settings.value, ...change };
  };

  #take(choice: ProgramChoice): void {
    const chosen = programChoiceText(choice);
    this.#remembered.value = chosen;
    this.#page.program.value = chosen;
    this.#page.besideChanged();
  }
}

const isTarget = ({ target }: ProgramChoice): boolean => programTargets.some(({ id }) => id === target);
