/** An entry of the browser's history: the address behind `#`, and the text that stands in the page's input beside it. */
export interface HistoryEntry {
  readonly hash: string;
  readonly input: string;
}

export const sameEntry = (one: HistoryEntry, other: HistoryEntry): boolean =>
  one.hash === other.hash && one.input === other.input;

/** What is done to the browser's history: its present entry is changed, or an entry is added behind it. */
export interface HistoryAct {
  readonly kind: 'replace' | 'push';
  readonly entry: HistoryEntry;
}

/** Whether the frame changes by a step of its own, in place as while typing, or in place where it waits behind another view (`wait`). */
export type How = 'step' | 'edit' | 'wait';

/**
 * Ends the typing of a field. What was typed becomes an entry of its own, and Back returns to what stood before it: the
 * address may have followed the typing, so that the entry of the step before gets its own address back first.
 *
 * @param now the entry of the frame and the input as they are now
 * @param stepped the entry at the last step
 * @param elsewhere whether another view is open; a field that is left because its view is left ends no step
 */
export function stepPlan(now: HistoryEntry, stepped: HistoryEntry, elsewhere: boolean): readonly HistoryAct[] {
  if (elsewhere || sameEntry(now, stepped)) return [];
  return [
    { kind: 'replace', entry: stepped },
    { kind: 'push', entry: now },
  ];
}

/** What is done to show a frame, in this order. */
export type ShowAct = 'close-view' | 'commit' | 'edit';

/** Shows a frame. From another view it is a step in any case: a frame is shown where frames are, and Back returns to that view. */
export function showPlan(how: How, elsewhere: boolean): readonly ShowAct[] {
  if (elsewhere && how !== 'wait') return ['close-view', 'edit', 'commit'];
  return how === 'step' ? ['commit', 'edit', 'commit'] : ['edit'];
}
