import {
  type Draft,
  evaluate,
  firstDraft,
  type HistoryAct,
  type How,
  type LinkReading,
  readInFull,
  readLink,
  showPlan,
  stepPlan,
  writeLink,
} from '../../workbench/index.ts';
import { Cell, Derived } from './cell.ts';
import { openView, viewAt } from './open-view.ts';

/** The frame at hand as typed. Everything shown follows from it. */
export const draft = new Cell<Draft>(firstDraft);

export const evaluation = new Derived(draft, evaluate);

/** The address, where it could not be read in full, and what was read. */
export interface BrokenAddress {
  readonly hash: string;
  readonly reading: LinkReading;
}

export const brokenLink = new Cell<BrokenAddress | undefined>(undefined);

/** Browsers limit how often the address may change, so that it follows typing at a little distance. */
const ADDRESS_DELAY = 250;
let pending: ReturnType<typeof setTimeout> | undefined;

/** The address at the last step, to which Back returns from what is being typed. */
let stepped = '';

/** Speaks to the device that a draft names; it comes with the devices. */
let speakTo = (_device: string): void => undefined;

const currentHash = () => `#${writeLink(draft.value, evaluation.value.controls)}`;

/** Lets the devices follow the draft, and the draft that is there already. */
export function onDevice(speak: (device: string) => void): void {
  speakTo = speak;
  if (draft.value.device !== undefined) speak(draft.value.device);
}

function put(next: Draft): void {
  const before = draft.value.device;
  draft.value = next;
  if (next.device !== undefined && next.device !== before) speakTo(next.device);
}

/** Changes the draft while something is being typed: the address follows in place. */
export function edit(next: Draft): void {
  put(next);
  brokenLink.value = undefined;
  clearTimeout(pending);
  pending = setTimeout(follow, ADDRESS_DELAY);
}

/** Brings the address up to what is typed, in place. */
export function follow(): void {
  clearTimeout(pending);
  if (pending === undefined) return;
  pending = undefined;
  act({ kind: 'replace', hash: currentHash() });
}

/** Ends the typing of a field: what was typed becomes a step, and Back returns to what stood before it. */
export function commit(): void {
  clearTimeout(pending);
  pending = undefined;
  const hash = currentHash();
  const plan = stepPlan(hash, stepped, openView.value !== undefined);
  for (const each of plan) act(each);
  if (plan.length > 0) stepped = hash;
}

function act({ kind, hash }: HistoryAct): void {
  const address = hash || location.pathname + location.search;
  if (kind === 'push') history.pushState(null, '', address);
  else history.replaceState(null, '', address);
}

/** Shows a frame; from another view, where frames are. */
export function show(next: Draft, how: How): void {
  for (const each of showPlan(how, openView.value !== undefined)) {
    if (each === 'close-view') openView.value = undefined;
    else if (each === 'edit') edit(next);
    else commit();
  }
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
  const read = readLink(stepped);
  put(read?.draft ?? firstDraft);
  brokenLink.value = read && !readInFull(read) ? { hash: stepped, reading: read } : undefined;
}
