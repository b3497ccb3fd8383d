import { execFile } from 'node:child_process';
import { cp, mkdtemp, rm, symlink, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

/** What a checking program answered. */
export interface Verdict {
  readonly passed: boolean;
  readonly output: string;
}

/** A copy of the sources and of what checks them, in which violations can be planted. */
export interface Sandbox {
  /** Runs a check while the given files (by path below src/) stand among the sources. */
  planted(files: Readonly<Record<string, string>>, check: Check): Promise<Verdict>;
  remove(): Promise<void>;
}

/** `types` is what `npm run types` does for the sources; the others are the parts of `npm run lint`. */
export type Check = 'types' | 'lint' | 'references' | 'rooms';

const root = resolve(import.meta.dirname, '../../..');

const commands: Readonly<Record<Check, readonly string[]>> = {
  types: ['node_modules/typescript/bin/tsc', '-b', '--pretty', 'false', 'src', 'src/words', 'src/ui'],
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

const copied = [
  'src',
  'scripts',
  'biome.json',
  'package.json',
  'tsconfig.base.json',
  'tsconfig.layer.json',
  '.gitignore',
];

export async function makeSandbox(): Promise<Sandbox> {
  const folder = await mkdtemp(join(tmpdir(), 'framewright-layering-'));
  await Promise.all(copied.map((name) => cp(join(root, name), join(folder, name), { recursive: true })));
  await symlink(join(root, 'node_modules'), join(folder, 'node_modules'), 'junction');

  const check = (name: Check) =>
    new Promise<Verdict>((done) => {
      execFile(process.execPath, [...commands[name]], { cwd: folder }, (error, stdout, stderr) =>
        done({ passed: error === null, output: stdout + stderr }),
      );
    });

  return {
    async planted(files, name) {
      const paths = Object.keys(files).map((path) => join(folder, 'src', path));
      await Promise.all(Object.values(files).map((text, index) => writeFile(paths[index]!, text, { flag: 'wx' })));
      try {
        return await check(name);
      } finally {
        await Promise.all(paths.map((path) => rm(path)));
      }
    },
    remove: () => rm(folder, { recursive: true }),
  };
}
