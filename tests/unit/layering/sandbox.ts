import { execFile } from 'node:child_process';
import { readdirSync } from 'node:fs';
import { cp, mkdir, mkdtemp, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { dirname, join, resolve } from 'node:path';

/** What a checking program answered. */
export interface Verdict {
  readonly passed: boolean;
  readonly output: string;
}

/** `types` is what `npm run types` does for the page and the layers below it; the others are the parts of `npm run lint`. */
export type Check = 'types' | 'lint' | 'references' | 'rooms';

const root = resolve(import.meta.dirname, '../../..');

const commands: Readonly<Record<Check, readonly string[]>> = {
  types: ['node_modules/typescript/bin/tsc', '-b', '--pretty', 'false', 'src/ui'],
  lint: [
    'node_modules/@biomejs/biome/bin/biome',
    'lint',
    '--error-on-warnings',
    '--max-diagnostics=none',
    '--colors=off',
    'src',
  ],
  references: ['scripts/no-triple-slash.mjs'],
  rooms: ['scripts/page-rooms.mjs'],
};

const layers = readdirSync(join(root, 'src'), { withFileTypes: true })
  .filter((entry) => entry.isDirectory())
  .map(({ name }) => name);

const copied = [
  'scripts',
  'biome.json',
  'package.json',
  'tsconfig.base.json',
  'tsconfig.layer.json',
  '.gitignore',
  ...layers.map((layer) => `src/${layer}/tsconfig.json`),
];

/**
 * Runs a check on the given files (by path below src/) in a copy of what checks the sources. The sources themselves are left
 * out, because they are checked as they are, and a run over them costs seconds: each layer below the page has an empty `index.ts`
 * instead.
 */
export async function verdictOn(files: Readonly<Record<string, string>>, check: Check): Promise<Verdict> {
  const folder = await mkdtemp(join(tmpdir(), 'framewright-layering-'));
  try {
    await Promise.all(copied.map((name) => cp(join(root, name), join(folder, name), { recursive: true })));
    await symlink(join(root, 'node_modules'), join(folder, 'node_modules'), 'junction');
    const below = layers.filter((layer) => layer !== 'ui');
    const empty = Object.fromEntries(below.map((layer) => [`${layer}/index.ts`, 'export {};\n']));
    for (const [name, text] of Object.entries({ ...empty, ...files })) {
      const path = join(folder, 'src', name);
      await mkdir(dirname(path), { recursive: true });
      await writeFile(path, text);
    }
    return await new Promise<Verdict>((done) => {
      execFile(process.execPath, [...commands[check]], { cwd: folder }, (error, stdout, stderr) =>
        done({ passed: error === null, output: stdout + stderr }),
      );
    });
  } finally {
    await rm(folder, { recursive: true });
  }
}
