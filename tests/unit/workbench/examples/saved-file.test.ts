import { describe, expect, it } from 'vitest';
import { readSaved, writeSaved } from '../../../../src/workbench/examples/saved-file.ts';

const frames = [
  { name: 'Pump start', link: 'rtu/request?unitId=6&functionCode=6&address=0x02AB&value=4096' },
  { name: 'Näme “q” 读', link: 'tcp/request?unitId=abc&functionCode=3' },
];
const file = (rows: unknown, version: unknown = 1) =>
  JSON.stringify({ format: 'framewright-frames', version, frames: rows });

describe('a file of saved frames', () => {
  it('gives back what was written, invalid drafts too', () => {
    expect(readSaved(writeSaved(frames))).toEqual({ kind: 'list', frames, bad: [] });
    expect(readSaved(`\uFEFF${writeSaved(frames)}`)).toEqual({ kind: 'list', frames, bad: [] });
    expect(readSaved(writeSaved([]))).toEqual({ kind: 'list', frames: [], bad: [] });
  });

  it('is this, so that an older page and a person can read it', () => {
    expect(JSON.parse(writeSaved(frames))).toEqual({ format: 'framewright-frames', version: 1, frames });
  });

  for (const [what, text, fault] of [
    ['cut off', '{"format": "framewright-frames", "vers', { code: 'not-json' }],
    ['empty', '', { code: 'not-json' }],
    ['a number', '7', { code: 'not-saved-frames' }],
    ['null', 'null', { code: 'not-saved-frames' }],
    ['a list', '[]', { code: 'not-saved-frames' }],
    ['another file', '{"name": "x"}', { code: 'not-saved-frames' }],
    ['without a version', JSON.stringify({ format: 'framewright-frames', frames }), { code: 'not-saved-frames' }],
    ['of a newer page', file(frames, 2), { code: 'newer-version', version: 2 }],
    ['of version 0', file(frames, 0), { code: 'not-saved-frames' }],
    ['with frames that are no list', file({ 0: frames[0] }), { code: 'not-saved-frames' }],
  ] as const) {
    it(`${what} is none, and says why`, () => {
      expect(readSaved(text)).toMatchObject({ kind: 'unreadable', fault });
    });
  }

  it('names each bad row and keeps it as it is, beside the good ones', () => {
    const link = 'rtu/request?functionCode=3';
    const rows = [
      frames[0],
      7,
      null,
      ['a'],
      { link },
      { name: ' \n', link },
      { name: 'x'.repeat(201), link },
      { name: 'a' },
      { name: 'a', link: '' },
      { name: 'a', link: 'rtu/question?functionCode=3' },
      { name: 'a', link: 'rtu/request?%25=3' },
      frames[1],
    ];
    const read = readSaved(file(rows));
    expect(read).toMatchObject({ kind: 'list', frames });
    const bad = read.kind === 'list' ? read.bad : [];
    expect(bad.map(({ row, why }) => [row, why])).toEqual([
      [2, 'not-a-row'],
      [3, 'not-a-row'],
      [4, 'not-a-row'],
      [5, 'no-name'],
      [6, 'no-name'],
      [7, 'name-too-long'],
      [8, 'no-link'],
      [9, 'no-link'],
      [10, 'unknown-link'],
      [11, 'unknown-link'],
    ]);
    const again = readSaved(writeSaved(frames, bad));
    expect(again).toMatchObject({ kind: 'list', frames });
    expect(again.kind === 'list' && again.bad.map(({ raw }) => raw)).toEqual(bad.map(({ raw }) => raw));
  });
});
