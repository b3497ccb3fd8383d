import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { ofOthers, ofSoundFrames } from '../../../src/diagnosis/hypotheses/index.ts';
import { readPinned, writePinned } from './pinned.ts';

const TOLD = /^ {2}([a-z0-9+-]+) (?:certain|likely|possible) /gm;
const path = fileURLToPath(new URL('../../vectors/diagnosed.txt', import.meta.url));
const file = readFileSync(path, 'utf8');
const intro = file.slice(0, file.indexOf('\n#') + 1);
const pinned = readPinned(file);
/** Made in a test, and once. */
let made: readonly string[] | undefined;
const written = () => {
  made ??= pinned.map(writePinned);
  return made;
};

describe('what bytes tell, to the bit', () => {
  // Where a change is meant, `npm run unit -- diagnosed -u` writes the file again; its difference is read before it is kept.
  it('is as it was written down', async () => {
    await expect(`${intro}${written().join('\n\n')}\n`).toMatchFileSnapshot(path);
  });

  it('is written down of each finding there is', () => {
    const told = new Set(written().flatMap((block) => [...block.matchAll(TOLD)].map(([, code]) => code)));
    const codes = [...ofSoundFrames, ...ofOthers].flatMap((hypothesis) => hypothesis.codes);
    expect(codes.filter((code) => !told.has(code))).toEqual([]);
  });
});
