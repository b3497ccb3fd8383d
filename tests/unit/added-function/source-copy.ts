import { cp, mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

const root = resolve(import.meta.dirname, '../../..');

/** A copy of the sources with one function more, added as CONTRIBUTING says: a file, and its line in the catalogue. */
export interface SourceCopy {
  /** Imports a module of the copy, by its path below src/. Its type is that of the module it is a copy of. */
  load<Module>(path: string): Promise<Module>;
  remove(): Promise<void>;
}

export async function copyWith(name: string, description: string): Promise<SourceCopy> {
  const folder = await mkdtemp(join(tmpdir(), 'framewright-function-'));
  const copied = ['src', 'tsconfig.base.json', 'tsconfig.layer.json', 'package.json'];
  await Promise.all(copied.map((entry) => cp(join(root, entry), join(folder, entry), { recursive: true })));
  const functions = join(folder, 'src/modbus/functions');
  await writeFile(join(functions, '64-invented.ts'), description);
  const index = join(functions, 'index.ts');
  const text = await readFile(index, 'utf8');
  const added = text.replace('\n] as const;', `\n  ${name},\n] as const;`);
  if (added === text) throw new Error('the catalogue is not where it was');
  await writeFile(index, `import { ${name} } from './64-invented.ts';\n${added}`);
  return {
    load: (path) => import(/* @vite-ignore */ join(folder, 'src', path)),
    remove: () => rm(folder, { recursive: true }),
  };
}

/** The example of CONTRIBUTING, to the letter. */
export async function exampleOfContributing(): Promise<string> {
  const text = await readFile(join(root, 'CONTRIBUTING.md'), 'utf8');
  const example = /```ts\n(import [^`]*export const writeRecipe = [^`]*)```/.exec(text)?.[1];
  if (example === undefined) throw new Error('CONTRIBUTING has no example of a description');
  return example;
}
