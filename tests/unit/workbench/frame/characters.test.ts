import { expect, test } from 'vitest';
import { character, characters, worst } from '../../../../src/workbench/frame/characters.ts';

test('what can be printed is printed, CR and LF have names, all else is a dot', () => {
  const shown = [
    [0x00, '·'],
    [0x09, '·'],
    [0x0a, 'LF'],
    [0x0d, 'CR'],
    [0x20, '·'],
    [0x21, '!'],
    [0x3a, ':'],
    [0x41, 'A'],
    [0x7e, '~'],
    [0x7f, '·'],
    [0xff, '·'],
  ] as const;
  for (const [byte, text] of shown) expect(character(byte)).toBe(text);
  expect(characters(Uint8Array.of(0x3a, 0x30, 0x0d, 0x0a))).toBe(':0CRLF');
});

test('an error is worse than a warning, a warning than a note', () => {
  const span = { name: 'unitId', kind: 'unit', from: 0, to: 1 } as const;
  const of = (...severities: ('error' | 'warning' | 'note')[]) =>
    worst(severities.map((severity) => ({ code: 'function-zero', severity, section: 'AP 4.1', span })));
  expect(of()).toBeUndefined();
  expect(of('note', 'note')).toBe('note');
  expect(of('note', 'warning')).toBe('warning');
  expect(of('warning', 'note', 'error')).toBe('error');
});
