import type { FileFault } from '../../words/index.ts';
import { Cell } from '../cell.ts';
import { type BadRow, freeName, readSaved, type SavedFrame, writeSaved } from './saved-file.ts';

const KEY = 'framewright.saved-frames';

/** What the browser holds: a list, a text that is none and is left alone, or nothing because it refuses. */
export type Stored =
  | { readonly kind: 'list'; readonly frames: readonly SavedFrame[]; readonly bad: readonly BadRow[] }
  | { readonly kind: 'unreadable'; readonly fault: FileFault; readonly text: string }
  | { readonly kind: 'refused' };

/** Why a change was not stored. Nothing was changed then. */
export type Refusal = 'refused' | 'full' | 'unreadable' | 'gone';

/** A name that was asked for, and the one that was given. */
export interface Naming {
  readonly wanted: string;
  readonly got: string;
}

/** A deleted frame and its place in the list. */
export interface Deleted {
  readonly frame: SavedFrame;
  readonly index: number;
}

export interface Imported {
  readonly added: readonly Naming[];
  readonly already: number;
}

export const stored = new Cell<Stored>(load());

function load(): Stored {
  let text: string | null;
  try {
    text = localStorage.getItem(KEY);
  } catch {
    return { kind: 'refused' };
  }
  if (text === null) return { kind: 'list', frames: [], bad: [] };
  const reading = readSaved(text);
  return reading.kind === 'list' ? { ...reading, frames: withOwnNames(reading.frames) } : { ...reading, text };
}

/** Frames are told apart by their names; a list edited by hand may have one twice. */
function withOwnNames(frames: readonly SavedFrame[]): readonly SavedFrame[] {
  const links = new Map<string, string>();
  for (const { name, link } of frames) links.set(freeName(name, links), link);
  return Array.from(links, ([name, link]) => ({ name, link }));
}

/** Follows what other tabs store. Answers how to stop. */
export function followOtherTabs(): () => void {
  const follow = ({ key }: StorageEvent) => {
    if (key === KEY || key === null) stored.value = load();
  };
  addEventListener('storage', follow);
  return () => removeEventListener('storage', follow);
}

type Change<T> = { readonly frames: readonly SavedFrame[]; readonly result: T } | 'gone';

/** Changes the list as it is stored now, whatever this tab last saw of it. */
function change<T>(make: (frames: readonly SavedFrame[]) => Change<T>): T | Refusal {
  const now = load();
  stored.value = now;
  if (now.kind !== 'list') return now.kind;
  const changed = make(now.frames);
  if (changed === 'gone') return 'gone';
  const refusal = put(KEY, writeSaved(changed.frames, now.bad));
  if (refusal !== undefined) return refusal;
  stored.value = { ...now, frames: changed.frames };
  return changed.result;
}

function put(key: string, text: string): Refusal | undefined {
  try {
    localStorage.setItem(key, text);
    return undefined;
  } catch (error) {
    return error instanceof DOMException && /quota/i.test(error.name) ? 'full' : 'refused';
  }
}

const linksByName = (frames: readonly SavedFrame[]) => new Map(frames.map(({ name, link }) => [name, link]));

/** Adds a frame. Where its name is taken both are kept. */
export const saveFrame = (name: string, link: string): Naming | Refusal =>
  change((frames) => {
    const got = freeName(name, linksByName(frames));
    return { frames: [...frames, { name: got, link }], result: { wanted: name, got } };
  });

export const renameFrame = (from: string, to: string): Naming | Refusal =>
  change((frames) => {
    const others = frames.filter(({ name }) => name !== from);
    if (others.length === frames.length) return 'gone';
    const got = freeName(to, linksByName(others));
    return {
      frames: frames.map((frame) => (frame.name === from ? { ...frame, name: got } : frame)),
      result: { wanted: to, got },
    };
  });

export const deleteFrame = (name: string): Deleted | Refusal =>
  change((frames) => {
    const index = frames.findIndex((frame) => frame.name === name);
    const frame = frames[index];
    return frame === undefined ? 'gone' : { frames: frames.toSpliced(index, 1), result: { frame, index } };
  });

/** Brings a deleted frame back to its place. */
export const restoreFrame = ({ frame, index }: Deleted): Naming | Refusal =>
  change((frames) => {
    const got = freeName(frame.name, linksByName(frames));
    return { frames: frames.toSpliced(index, 0, { ...frame, name: got }), result: { wanted: frame.name, got } };
  });

/** Adds frames; those that are here already, name and all, are left as they are. */
export const importFrames = (incoming: readonly SavedFrame[]): Imported | Refusal =>
  change((frames) => {
    const links = linksByName(frames);
    const added: Naming[] = [];
    for (const { name, link } of incoming) {
      if (links.get(name) === link) continue;
      const got = freeName(name, links);
      links.set(got, link);
      added.push({ wanted: name, got });
    }
    const all = Array.from(links, ([name, link]) => ({ name, link }));
    return { frames: all, result: { added, already: incoming.length - added.length } };
  });

/** Moves a stored text that cannot be read to a key of its own, and begins an empty list. */
export function setUnreadableAside(): { readonly key: string } | Refusal {
  const now = load();
  stored.value = now;
  if (now.kind === 'refused') return 'refused';
  if (now.kind === 'list') return 'gone';
  let number = 1;
  while (localStorage.getItem(`${KEY}.unreadable-${number}`) !== null) number++;
  const key = `${KEY}.unreadable-${number}`;
  const refusal = put(key, now.text);
  if (refusal !== undefined) return refusal;
  localStorage.removeItem(KEY);
  stored.value = load();
  return { key };
}
