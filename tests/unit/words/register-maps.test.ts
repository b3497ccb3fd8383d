import { describe, expect, it } from 'vitest';
import { mapFaultCodes, mapNoticeCodes, meanings, questionCodes } from '../../../src/devices/index.ts';
import { languages } from '../../../src/words/index.ts';

const words = await languages.en.registerMaps();
const fault = { code: 'cell-missing', column: 'name' };

describe('what the import of a map says', () => {
  it('has a sentence for every code', () => {
    for (const code of mapFaultCodes)
      expect(
        words.fault({
          code,
          rows: [3],
          fault: code === 'own-file' ? { code: 'not-profiles' } : fault,
          format: 'json',
          detail: 'it ends early',
        }),
      ).toMatch(/^Row 3: [A-Z].*\.?$/);
    for (const code of mapNoticeCodes)
      expect(words.notice({ code, rows: [3, 4], fault, headers: ['Icon'], question: 'table' })).toMatch(
        /^Rows 3 and 4: [A-Z].*[.?]$/,
      );
    for (const code of questionCodes) expect(words.question({ code, options: [], assumed: '' })).toMatch(/\?$/);
    for (const meaning of meanings) expect(words.column('Reg', meaning, 'cells')).toContain(words.meanings[meaning]);
  });

  it('names rows, of many the first ones', () => {
    expect(words.fault({ code: 'address-missing', rows: [] })).toBe('The row has no address.');
    expect(words.notice({ code: 'unused', rows: [1, 2, 3, 4, 5, 6, 7, 8] })).toMatch(
      /^8 rows, starting with 1, 2, 3, 4, 5: /,
    );
  });

  it('says answers in words where they are none themselves', () => {
    expect(words.answer('five-digit')).toBe('Five digits, 40001 is the first');
    expect(words.answer('CDAB')).toBe('CDAB');
  });
});
