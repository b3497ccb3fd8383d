import { describe, expect, it } from 'vitest';
import { findFunctions } from '../../../../src/workbench/index.ts';

const names = (query: string) => findFunctions(query).map(({ name }) => name);

describe('functions are found', () => {
  it('by a part of their names, whatever the case', () => {
    expect(names('HOLDING')).toEqual(['03 Read Holding Registers']);
    expect(names('nothing of the kind')).toEqual([]);
    expect(names('  ')).toEqual([]);
  });

  it('by a code in decimal or hexadecimal, before names that hold its digits', () => {
    // 16 is function 0x10, and hexadecimal 16 is Mask Write Register.
    expect(names('16').slice(0, 2).sort()).toEqual(['10 Write Multiple Registers', '16 Mask Write Register']);
    expect(names('0x10')[0]).toBe('10 Write Multiple Registers');
    expect(names('10h')[0]).toBe('10 Write Multiple Registers');
    expect(findFunctions('2b')[0]?.texts).toEqual({ functionCode: '43' });
  });

  it('with the sub-functions and MEI types under them', () => {
    expect(names('2B/0E')).toEqual(['2B/0E Read Device Identification']);
    expect(findFunctions('restart communications')[0]?.texts).toEqual({ functionCode: '8', subFunction: '1' });
  });

  it('also where a code has no name, with whom it is for', () => {
    // 65 is user-defined (AP 4.1), hexadecimal 65 is 101, too; 0x80 is an exception, no function.
    expect(findFunctions('65')).toMatchObject([
      { code: 65, name: '41, 65', range: 'user-defined', texts: { functionCode: '65' } },
      { code: 101, name: '65, 101', range: 'user-defined' },
    ]);
    expect(findFunctions('0x80')).toEqual([]);
    expect(findFunctions('0').every(({ code }) => code > 0)).toBe(true);
  });

  it('at most eight at a time', () => {
    expect(findFunctions('e')).toHaveLength(8);
  });
});
