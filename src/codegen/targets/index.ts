import type { Target } from '../target.ts';

/** Every target, in the order in which they are offered. */
export const targets: readonly Target[] = [];
