import { computed, type ReadonlySignal } from '@preact/signals-core';
import { envelopeSection, type Field, fieldValue, type Problem, type Section, type Span } from '../modbus/index.ts';
import {
  type Control,
  controlsByPath,
  type Draft,
  formLayout,
  headerText,
  type InputError,
  withForce,
  withoutGroup,
  withText,
} from '../workbench/index.ts';
import type { Page } from './page.ts';
import { steady } from './steady.ts';

/** What is known of one field of the draft, each a signal of its own: it changes only if it says something else. */
export interface FieldParts {
  /** The control with its text. */
  readonly control: ReadonlySignal<Control | undefined>;
  /** `undefined` for a field of the envelope, and if the frame has no field at this path. */
  readonly field: ReadonlySignal<Field | undefined>;
  /** Where it stands what is legal. */
  readonly section: ReadonlySignal<Section>;
  readonly text: ReadonlySignal<string>;
  /** The text it is forced to. */
  readonly forced: ReadonlySignal<string | undefined>;
  readonly error: ReadonlySignal<InputError | undefined>;
  /** The number that the frame has; `undefined` if it has none here. */
  readonly value: ReadonlySignal<number | undefined>;
  /** The bytes of the frame that hold it. */
  readonly span: ReadonlySignal<Span | undefined>;
  readonly problems: ReadonlySignal<readonly Problem[]>;
  /** The paths of the fields in each of its groups. */
  readonly groups: ReadonlySignal<readonly (readonly string[])[]>;
}

/** The form of the draft, field by field, and what is typed and chosen in it. */
export class Fields {
  readonly layout;
  readonly #page: Page;
  readonly #controls;
  #before: Draft | undefined;
  readonly #parts = new Map<string, FieldParts>();

  constructor(page: Page) {
    this.#page = page;
    this.#controls = computed(() => controlsByPath(page.evaluation.value.controls));
    this.layout = steady(() => formLayout(page.draft.value, page.evaluation.value));
  }

  /** The parts of the field at a path (`unitId`, `registers`, `subRequests[0].fileNumber`), or of a derived one by its name. */
  at(path: string): FieldParts {
    const found = this.#parts.get(path) ?? this.#partsOf(path);
    this.#parts.set(path, found);
    return found;
  }

  /** Takes the text of a field while it is typed. */
  readonly type = (path: string, text: string): void => this.#page.edit(withText(this.#draft, path, text));

  /** Takes the text of a field as a step of its own. */
  readonly choose = (path: string, text: string): void => this.#page.step(withText(this.#draft, path, text));

  /** Takes the texts of several fields as one step. */
  readonly chooseAll = (texts: Readonly<Record<string, string>>): void =>
    this.#page.step(Object.entries(texts).reduce((draft, [path, text]) => withText(draft, path, text), this.#draft));

  readonly typeForced = (path: string, text: string): void => this.#page.edit(withForce(this.#draft, path, text));

  /** Forces a derived value; `undefined` lets the encoder work it out again. */
  readonly force = (path: string, text: string | undefined): void =>
    this.#page.step(withForce(this.#draft, path, text));

  /** Remembers the draft as it is when a field gets the focus, or what was typed in it is taken. */
  readonly enter = (): void => {
    this.#before = this.#draft;
  };

  /** Takes what was typed as a step. */
  readonly take = (): void => {
    this.#page.commit();
    this.enter();
  };

  /** Gives back what stood in a field when it got the focus. Answers whether something else stood there. */
  readonly giveBack = (): boolean => {
    const before = this.#before;
    if (before === undefined || before === this.#draft) return false;
    this.#page.edit(before);
    return true;
  };

  /** Removes one of the groups of a field, by its index. */
  readonly removeGroup = (path: string, index: number): void =>
    this.#page.step(withoutGroup(this.#draft, path, index, this.at(path).groups.peek().length));

  get #draft(): Draft {
    return this.#page.draft.peek();
  }

  #partsOf(path: string): FieldParts {
    const { draft, evaluation } = this.#page;
    const control = steady(() => this.#controls.value.get(path));
    const reading = computed(() => evaluation.value.frame?.reading);
    const found = computed(() => reading.value?.spans.find(({ name }) => name === path));
    return {
      control,
      field: computed(() => control.value?.field),
      section: computed(() => control.value?.section ?? envelopeSection(draft.value.transport, path)),
      text: computed(() => control.value?.text ?? (isHeader(path) ? headerText(draft.value, path) : '')),
      forced: computed(() => draft.value.force[path]),
      error: steady(() => evaluation.value.errors.get(path)),
      value: computed(() => {
        const value = reading.value && fieldValue(reading.value, path);
        return typeof value === 'number' ? value : undefined;
      }),
      span: steady(() => found.value),
      problems: steady(() => reading.value?.problems.filter(({ span }) => span === found.value) ?? []),
      groups: steady(() => control.value?.groups.map((group) => group.map((inner) => inner.path)) ?? []),
    };
  }
}

const isHeader = (path: string): path is Parameters<typeof headerText>[1] =>
  path === 'unitId' || path === 'transactionId' || path === 'functionCode';
