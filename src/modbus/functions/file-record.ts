import type { Rule } from '../field.ts';
import { choice, u16, within } from '../fields/number.ts';

/** Always 06 (AP 6.14, AP 6.15). */
export const referenceType = choice('referenceType', [6]);

const highNumber: Rule<number> = (got) => (got > 10 ? { code: 'file-number-high', severity: 'note', got } : undefined);

/** 1…FFFF; above 10 older devices may not take part (AP 6.14). */
export const fileNumber = u16('fileNumber', { range: within(1, 0xffff), rules: [highNumber] });

/** The first register in the file, counted from 0 up to 270F (AP 6.14). */
export const recordNumber = u16('recordNumber', { kind: 'address', range: within(0, 9999) });
