import type { UnitScale } from '../../../notation/index.ts';
import { KeptChoice } from '../../../store/index.ts';
import { firstScale, type ScaleTexts, scaleWithUnit, storedScale } from '../../../workbench/index.ts';
import { storage } from '../../parts/store.ts';

/** The scale typed last, which other fields follow. */
export const scaleTexts = new KeptChoice<ScaleTexts>(storage, 'scale', firstScale, storedScale);

export function setScale(change: Partial<ScaleTexts>): void {
  scaleTexts.value = { ...scaleTexts.value, ...change };
}

/** The person's own scale, if it has a unit that can be typed. */
export const ownScale = (): UnitScale | undefined => scaleWithUnit(scaleTexts.value);
