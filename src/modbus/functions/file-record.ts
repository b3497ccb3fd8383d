import type { Rule } from '../field.ts';
import { choice, u16, within } from '../fields/number.ts';

/** Always 06 (AP 6.14, AP 6.15). */
export const referenceType = choice('referenceType', [6]);

const files = { least: 1, most: 0xffff };
const highNumber: Rule<number> = (got) => (got > 10 ? { code: 'file-number-high', severity: 'note', got } : undefined);

/** 1…FFFF; above 10 older devices may not take part (AP 6.14). */
export const fileNumber = u16('fileNumber', { range: files, rules: [within(files), highNumber] });

const records = { least: 0, most: 9999 };

/** The first register in the file, 0…270F (AP 6.14). */
export const recordNumber = u16('recordNumber', { range: records, rules: [within(records)] });
