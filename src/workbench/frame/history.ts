/** What is done to the browser's history: the address of its present entry is changed, or an entry is added behind it. */
export type HistoryAct = { readonly kind: 'replace' | 'push'; readonly hash: string };

/** Whether the frame changes by a step of its own, or in place as while typing. */
export type How = 'step' | 'edit';

/**
 * Ends the typing of a field. What was typed becomes an entry of its own, and Back returns to what stood before it: the
 * address may have followed the typing, so that the entry of the step before gets its own address back first.
 *
 * @param hash the address of the frame as it is now
 * @param stepped the address at the last step
 * @param elsewhere whether another view is open; a field that is left because its view is left ends no step
 */
export function stepPlan(hash: string, stepped: string, elsewhere: boolean): readonly HistoryAct[] {
  if (hash === stepped || elsewhere) return [];
  return [
    { kind: 'replace', hash: stepped },
    { kind: 'push', hash },
  ];
}

/** What is done to show a frame, in this order. */
export type ShowAct = 'close-view' | 'commit' | 'edit';

/** Shows a frame. From another view it is a step in any case: a frame is shown where frames are, and Back returns to that view. */
export function showPlan(how: How, elsewhere: boolean): readonly ShowAct[] {
  if (elsewhere) return ['close-view', 'edit', 'commit'];
  return how === 'step' ? ['commit', 'edit', 'commit'] : ['edit'];
}
