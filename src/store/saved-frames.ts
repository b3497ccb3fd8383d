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
import { type PageStorage, StoredList } from './storage.ts';

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

  readonly delete = (wanted: string): Removed<SavedFrame> | Refusal => this.remove(({ name }) => name === wanted);

  /** Brings a deleted frame back to its place. */
  readonly restore = ({ item, index }: Removed<SavedFrame>): Naming | Refusal =>
    this.change((frames) => {
      const got = freeName(item.name, linksByName(frames));
      return { items: frames.toSpliced(index, 0, { ...item, name: got }), result: { wanted: item.name, got } };
    });

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
