import { type Signal, signal } from '@preact/signals-core';
import {
  type BadRow,
  type FileFault,
  freeName,
  type Refusal,
  type Removed,
  readSaved,
  type SavedFrame,
  writeSaved,
} from '../workbench/index.ts';
import type { PageStorage } from './storage.ts';
import { StoredList } from './stored-list.ts';

/** A name that was asked for, and the one that was given. */
export interface Naming {
  readonly wanted: string;
  readonly got: string;
}

/** How many frames an import found here already, and those it added. */
export interface Imported {
  readonly added: readonly Naming[];
  readonly already: number;
}

/** The frames kept in this browser, told apart by their names. */
export class SavedFrames extends StoredList<SavedFrame, FileFault, BadRow> {
  /** What was deleted here, the latest last. */
  readonly deleted: Signal<readonly Removed<SavedFrame>[]> = signal([]);

  constructor(storage: PageStorage) {
    super(storage, 'saved-frames', {
      read(text) {
        const reading = readSaved(text);
        return reading.kind === 'list'
          ? { kind: 'list', items: withOwnNames(reading.frames), bad: reading.bad }
          : reading;
      },
      write: writeSaved,
    });
  }

  /** Adds a frame. Where its name is taken both are kept. */
  readonly save = (name: string, link: string): Naming | Refusal =>
    this.change((frames) => {
      const got = freeName(name, linksByName(frames));
      return { items: [...frames, { name: got, link }], result: { wanted: name, got } };
    });

  readonly rename = (from: string, to: string): Naming | Refusal =>
    this.change((frames) => {
      const others = frames.filter(({ name }) => name !== from);
      if (others.length === frames.length) return 'gone';
      const got = freeName(to, linksByName(others));
      return {
        items: frames.map((frame) => (frame.name === from ? { ...frame, name: got } : frame)),
        result: { wanted: to, got },
      };
    });

  readonly delete = (wanted: string): Removed<SavedFrame> | Refusal => {
    const outcome = this.remove(({ name }) => name === wanted);
    if (typeof outcome !== 'string') this.deleted.value = [...this.deleted.value, outcome];
    return outcome;
  };

  /** Brings the frame that was deleted last back to its place; `gone` if none was deleted. */
  readonly undo = (): Naming | Refusal => {
    const last = this.deleted.value.at(-1);
    if (last === undefined) return 'gone';
    const outcome = this.change((frames) => {
      const got = freeName(last.item.name, linksByName(frames));
      return {
        items: frames.toSpliced(last.index, 0, { ...last.item, name: got }),
        result: { wanted: last.item.name, got },
      };
    });
    if (typeof outcome !== 'string') this.deleted.value = this.deleted.value.slice(0, -1);
    return outcome;
  };

  /** Adds frames; those that are here already, name and all, are left as they are. */
  readonly import = (incoming: readonly SavedFrame[]): Imported | Refusal =>
    this.change((frames) => {
      const links = linksByName(frames);
      const added: Naming[] = [];
      for (const { name, link } of incoming) {
        if (links.get(name) === link) continue;
        const got = freeName(name, links);
        links.set(got, link);
        added.push({ wanted: name, got });
      }
      const all = Array.from(links, ([name, link]) => ({ name, link }));
      return { items: all, result: { added, already: incoming.length - added.length } };
    });
}

/** A list edited by hand may have a name twice. */
function withOwnNames(frames: readonly SavedFrame[]): readonly SavedFrame[] {
  const links = new Map<string, string>();
  for (const { name, link } of frames) links.set(freeName(name, links), link);
  return Array.from(links, ([name, link]) => ({ name, link }));
}

const linksByName = (frames: readonly SavedFrame[]) => new Map(frames.map(({ name, link }) => [name, link]));
