import { signal } from '@preact/signals';
import type { TargetedKeyboardEvent } from 'preact';
import { useLayoutEffect, useRef } from 'preact/hooks';

/** How a text that is shown is edited where it stands. */
export interface CellEdit {
  /** Tells it from all others that can be edited. In a grid it begins with the key of its row and `-`. */
  readonly id: string;
  readonly label: string;
  /** The text with which editing begins. */
  readonly text: string;
  /** What it may be, if that is one of a few. */
  readonly choices?: readonly { readonly value: string; readonly name: string }[] | undefined;
  /** What may be typed, for those who hear the page. */
  readonly hint?: string | undefined;
  /** What is wrong with a text, and what would be right; blank if nothing is wrong. */
  readonly fault: (text: string) => string;
  readonly take: (text: string) => void;
}

/** Where the focus goes when a text was taken or given up; `nowhere` if it is somewhere else already. */
export type CellExit = 'back' | 'down' | 'up' | 'next' | 'previous' | 'nowhere';

interface Draft {
  readonly text: string;
  /** It was to be taken, and was wrong: from then on is said what is wrong. */
  readonly tried: boolean;
}

/** The texts that are being typed in cells. One that is wrong stays until it is right, or given up. */
export class Drafts {
  readonly #drafts = signal<ReadonlyMap<string, Draft>>(new Map());
  /** What has been begun, and gets the focus when it is drawn. */
  begun: string | undefined;

  of({ id }: CellEdit): Draft | undefined {
    return this.#drafts.value.get(id);
  }

  get ids(): readonly string[] {
    return [...this.#drafts.value.keys()];
  }

  /** What is wrong with a text that was to be taken; blank if nothing is. */
  faultOf(edit: CellEdit): string {
    const draft = this.of(edit);
    return draft?.tried ? edit.fault(draft.text) : '';
  }

  begin({ id, text }: CellEdit): void {
    this.begun = id;
    this.set(id, { text, tried: false });
  }

  set(id: string, draft: Draft): void {
    this.#drafts.value = new Map([...this.#drafts.value, [id, draft]]);
  }

  drop(id: string): void {
    this.#drafts.value = new Map([...this.#drafts.value].filter(([other]) => other !== id));
  }
}

interface CellInputProps {
  readonly edit: CellEdit;
  readonly drafts: Drafts;
  readonly onExit: (exit: CellExit) => void;
}

/** The id of what is said about a text that is edited. */
export const cellSaidId = ({ id }: CellEdit): string => `${id}-said`;

/** The text of a cell while it is edited: Enter and Tab take it and go on, Escape gives it up, and leaving it takes it. */
export function CellInput({ edit, drafts, onExit }: CellInputProps) {
  const root = useRef<HTMLInputElement & HTMLSelectElement>(null);
  /** An element that is taken away loses the focus too. */
  const ended = useRef(false);
  useLayoutEffect(() => {
    if (drafts.begun !== edit.id) return;
    drafts.begun = undefined;
    root.current?.focus();
    root.current?.select?.();
  }, []);
  const draft = drafts.of(edit) ?? { text: edit.text, tried: false };
  const end = (exit: CellExit) => {
    ended.current = true;
    drafts.drop(edit.id);
    onExit(exit);
  };
  const finish = (exit: CellExit) => {
    if (ended.current) return;
    if (draft.text === edit.text) return end(exit);
    if (edit.fault(draft.text) !== '') return drafts.set(edit.id, { ...draft, tried: true });
    end(exit);
    edit.take(draft.text);
  };
  const press = (event: TargetedKeyboardEvent<HTMLElement>) => {
    const { key, shiftKey } = event;
    event.stopPropagation();
    if (key === 'Escape') end('back');
    else if (key === 'Enter') finish(shiftKey ? 'up' : 'down');
    else if (key === 'Tab') finish(shiftKey ? 'previous' : 'next');
    else return;
    event.preventDefault();
  };
  const shared = {
    ref: root,
    class: 'cell-input mono',
    'aria-label': edit.label,
    'aria-invalid': drafts.faultOf(edit) !== '',
    'aria-describedby': cellSaidId(edit),
    value: draft.text,
    onKeyDown: press,
    onFocusOut: () => finish('nowhere'),
  };
  const change = (text: string) => drafts.set(edit.id, { ...draft, text });
  if (edit.choices)
    return (
      <select {...shared} onChange={({ currentTarget }) => change(currentTarget.value)}>
        {edit.choices.map(({ value, name }) => (
          <option key={value} value={value}>
            {name}
          </option>
        ))}
      </select>
    );
  return (
    <input
      {...shared}
      autocomplete="off"
      spellcheck={false}
      autocapitalize="off"
      onInput={({ currentTarget }) => change(currentTarget.value)}
    />
  );
}

interface CellSaidProps {
  readonly edit: CellEdit;
  readonly drafts: Drafts;
}

/** What is wrong with a text that is edited, or else what may be typed, for those who hear the page. */
export function CellSaid({ edit, drafts }: CellSaidProps) {
  if (drafts.of(edit) === undefined) return null;
  const fault = drafts.faultOf(edit);
  return (
    <p id={cellSaidId(edit)} class={fault === '' ? 'unseen' : 'error'} aria-live="polite">
      {fault === '' ? edit.hint : fault}
    </p>
  );
}

/** A text that is edited where it stands, outside of a grid: a button begins it. It is found by its `data-focus`. */
export function EditedText({ edit, drafts, onExit, children }: CellInputProps & { readonly children: string }) {
  return (
    <>
      {drafts.of(edit) ? (
        <CellInput edit={edit} drafts={drafts} onExit={onExit} />
      ) : (
        <button
          type="button"
          class="cell-text"
          aria-label={`${edit.label}: ${children}`}
          data-focus={edit.id}
          onClick={() => drafts.begin(edit)}
        >
          {children}
        </button>
      )}
      <CellSaid edit={edit} drafts={drafts} />
    </>
  );
}
