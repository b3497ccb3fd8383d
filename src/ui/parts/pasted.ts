import { signal } from '@preact/signals';
import type { Identity } from '../../diagnosis/index.ts';
import type { ByteNotation } from '../../notation/index.ts';
import {
  draftOf,
  firstFrame,
  type How,
  type ItemIdentity,
  identityOf,
  readText,
  type TextReading,
} from '../../workbench/index.ts';
import { show } from './store.ts';
import { type Running, startWorker } from './workers/start-worker.ts';

/** The text to read as it stands, what it was read as, and whether a worker is still at it. */
export type Pasted =
  | { readonly kind: 'empty' }
  | { readonly kind: 'reading'; readonly text: string }
  /** The worker ended over it: too long, perhaps, for the memory there is. */
  | { readonly kind: 'failed'; readonly text: string }
  | {
      readonly kind: 'read';
      readonly reading: TextReading;
      /** The item whose frame was made the one at hand. */
      readonly chosen: number;
    };

/** Longer texts, in characters, are read by a worker. */
const LONG = 50_000;
/** Texts up to this long, in characters, outlive a reload. */
const KEPT = 200_000;
const KEY = 'framewright.pasted';

export const pasted = signal<Pasted>({ kind: 'empty' });

/** Whether the panel with the text is open. */
export const opened = signal(false);

let worker: Running<{ text: string; as: ByteNotation | undefined }> | undefined;

/** Reads a text; `as` says in which notation, where the page's own choice was not meant. */
export function read(text: string, how: How, as?: ByteNotation): void {
  stop();
  keep(text);
  if (text.trim() === '') {
    pasted.value = { kind: 'empty' };
  } else if (text.length <= LONG) {
    take(readText(text, as), how);
  } else {
    pasted.value = { kind: 'reading', text };
    const done = (reading: TextReading) => {
      stop();
      take(reading, how);
    };
    worker = startWorker('reader', done, (why) => {
      // A worker that does not come is done without, although the page stands still meanwhile.
      if (why === 'died') pasted.value = { kind: 'failed', text };
      else done(readText(text, as));
    });
    worker.post({ text, as });
  }
}

/** Gives up on what a worker reads. */
export function cancel(): void {
  stop();
  pasted.value = { kind: 'empty' };
}

function stop(): void {
  worker?.end();
  worker = undefined;
}

function take(reading: TextReading, how: How): void {
  const chosen = firstFrame(reading);
  pasted.value = { kind: 'read', reading, chosen };
  if (reading.items.length > 0) choose(chosen, how);
}

/** Makes an item's frame the one at hand: as a step, or in place while going through the list. */
export function choose(index: number, how: How): void {
  if (pasted.value.kind !== 'read') return;
  const { reading } = pasted.value;
  const found = identityAt(reading, index);
  if (found === undefined) return;
  pasted.value = { kind: 'read', reading, chosen: index };
  showReading(found.identities[0] as Identity, found.request, how);
}

/** Shows bytes as they were read; a reply with the request that it answers. */
export const showReading = ({ reading }: Pick<Identity, 'reading'>, request: Uint8Array | undefined, how: How): void =>
  show(draftOf(reading, reading.direction === 'response' ? request : undefined), how);

/** What was asked last: every drawing asks for the chosen item. */
let latest: { readonly of: TextReading; readonly index: number; readonly found: ItemIdentity | undefined } | undefined;

/** What an item may be, and the request that it answers, or was to answer. */
export function identityAt(of: TextReading, index: number) {
  if (latest?.of !== of || latest.index !== index) latest = { of, index, found: identityOf(of, index) };
  return latest.found;
}

function keep(text: string): void {
  try {
    if (text === '' || text.length > KEPT) sessionStorage.removeItem(KEY);
    else sessionStorage.setItem(KEY, text);
  } catch {
    // A browser that keeps nothing reads all the same.
  }
}

/** The text of before a reload is read again; the current frame is the address's own. */
export function restore(): void {
  let text: string | null = null;
  try {
    text = sessionStorage.getItem(KEY);
  } catch {
    return;
  }
  if (text === null || text.length > LONG) return;
  pasted.value = { kind: 'read', reading: readText(text, undefined), chosen: -1 };
  opened.value = true;
}
