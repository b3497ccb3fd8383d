import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { type LogPlace, logParts, logTabs, ownLogs, readLogPlace } from '../../../../src/workbench/index.ts';

const read = (parts: Readonly<Record<string, string>>) => readLogPlace(new Map(Object.entries(parts)));
const first: LogPlace = { source: undefined, filter: '', by: 'frame', record: undefined, tab: 'rows' };

describe('what an address says of a log', () => {
  it('is its source, filter, rows, the chosen frame and the tab', () => {
    expect(read({ log: 'demo', filter: 'unit:6 crc', rows: 'exchange', row: '36', tab: 'timeline' })).toEqual({
      place: { source: 'demo', filter: 'unit:6 crc', by: 'exchange', record: 35, tab: 'timeline' },
      untaken: [],
    });
    expect(read({})).toEqual({ place: first, untaken: [] });
    expect(read({ filter: 'unti:6' }).place.filter).toBe('unti:6');
  });

  it.each([
    ['log', 'other', 'log'],
    ['rows', 'byte', 'rows'],
    ['row', '0', 'row'],
    ['row', '-3', 'row'],
    ['row', '1e3', 'row'],
    ['row', '99999999999', 'row'],
    ['tab', '', 'tab'],
    ['fliter', 'crc', 'not-known'],
    ['constructor', '1', 'not-known'],
  ])('leaves out %s=%s, and tells', (name, text, code) => {
    expect(read({ [name]: text })).toEqual({ place: first, untaken: [{ code, name, text }] });
  });

  it('is written so that it is read as the same', () => {
    const place = fc.record({
      source: fc.constantFrom(undefined, 'pasted' as const, 'file' as const, ...ownLogs),
      filter: fc.string(),
      by: fc.constantFrom('frame' as const, 'exchange' as const),
      record: fc.option(fc.nat(999_999), { nil: undefined }),
      tab: fc.constantFrom(...logTabs),
    });
    fc.assert(
      fc.property(place, (one) => {
        const parts = Object.fromEntries(Object.entries(logParts(one)).filter(([, text]) => text !== ''));
        expect(read(parts)).toEqual({ place: one, untaken: [] });
      }),
    );
  });
});
