import type { UnitScale } from '../../../notation/index.ts';
import { firstScale, type ScaleTexts, scaleWithUnit, storedScale } from '../../../workbench/index.ts';
import { Cell } from '../../state/cell.ts';
import { Remembered } from '../../state/remembered.ts';

const remembered = new Remembered<ScaleTexts>('scale', firstScale, storedScale);

/** The scale typed last, which other fields follow. */
export const scaleTexts = new Cell<ScaleTexts>(remembered.value);

export function setScale(change: Partial<ScaleTexts>): void {
  remembered.value = { ...scaleTexts.value, ...change };
  scaleTexts.value = remembered.value;
}

/** The person's own scale, if it has a unit that can be typed. */
export const ownScale = (): UnitScale | undefined => scaleWithUnit(scaleTexts.value);
