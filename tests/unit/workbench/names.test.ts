import { describe, expect, it } from 'vitest';
import { freeName, plainName } from '../../../src/workbench/names.ts';

describe('names', () => {
  it('have no blanks around them and no runs of blanks', () => {
    expect(plainName('  Pump \n\t start ')).toBe('Pump start');
  });

  it('get the first number that is free', () => {
    expect(freeName('Pump', new Set())).toBe('Pump');
    expect(freeName('Pump', new Set(['Pump']))).toBe('Pump (2)');
    expect(freeName('Pump', new Set(['Pump', 'Pump (2)', 'Pump (4)']))).toBe('Pump (3)');
    expect(freeName('Pump (2)', new Set(['Pump (2)']))).toBe('Pump (3)');
    expect(freeName('constructor', new Set())).toBe('constructor');
  });
});
