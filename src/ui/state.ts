import { type BrokenLink, type Draft, evaluate, firstDraft, readLink, writeLink } from '../workbench/index.ts';
import { Cell, Derived } from './cell.ts';
import { openView, viewAt } from './other-views.ts';

/** The frame at hand as typed. Everything shown follows from it. */
export const draft = new Cell<Draft>(firstDraft);

export const evaluation = new Derived(draft, evaluate);

/** What of the address could not be read. */
export const brokenLink = new Cell<BrokenLink | undefined>(undefined);

/** Browsers limit how often the address may change, so that it follows typing at a little distance. */
const ADDRESS_DELAY = 250;
let pending: ReturnType<typeof setTimeout> | undefined;

/** The address at the last step, to which Back returns from what is being typed. */
let stepped = '';

const addressOf = (hash: string) => hash || location.pathname + location.search;
const currentHash = () => `#${writeLink(draft.value, evaluation.value.controls)}`;

/** Changes the draft while something is being typed: the address follows in place. */
export function edit(next: Draft): void {
  draft.value = next;
  brokenLink.value = undefined;
  clearTimeout(pending);
  pending = setTimeout(follow, ADDRESS_DELAY);
}

/** Brings the address up to what is typed, in place. */
export function follow(): void {
  clearTimeout(pending);
  if (pending === undefined) return;
  pending = undefined;
  history.replaceState(null, '', currentHash());
}

/** Ends the typing of a field: what was typed becomes a step, and Back returns to what stood before it. */
export function commit(): void {
  clearTimeout(pending);
  pending = undefined;
  const hash = currentHash();
  // A field that is left because its view is left ends no step.
  if (hash === stepped || openView.value) return;
  history.replaceState(null, '', addressOf(stepped));
  history.pushState(null, '', hash);
  stepped = hash;
}

/** Changes the draft by a step of its own. */
export function step(next: Draft): void {
  commit();
  edit(next);
  commit();
}

/** Takes the draft from the address: at the start, on Back and Forward, and when the address is changed by hand. */
export function takeAddress(): void {
  clearTimeout(pending);
  pending = undefined;
  stepped = location.hash;
  openView.value = viewAt(stepped);
  if (openView.value) return;
  const read = readLink(location.hash);
  draft.value = read?.draft ?? firstDraft;
  brokenLink.value = read && read.unknown.length > 0 ? { text: location.hash, unknown: read.unknown } : undefined;
}
