import type { Target } from '../target.ts';
import { arduino } from './arduino.ts';
import { c } from './c.ts';
import { structuredText } from './structured-text/structured-text.ts';

/** Every target, in the order in which they are offered. */
export const targets: readonly Target[] = [structuredText, c, arduino];
