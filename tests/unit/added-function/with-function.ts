import { readFile } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { runInThisContext } from 'node:vm';
import { build, type Plugin } from 'vite';
import type * as Layers from './layers.ts';

const root = resolve(import.meta.dirname, '../../..');
const functions = join(root, 'src/modbus/functions');
const [catalogue, invented] = [join(functions, 'index.ts'), join(functions, '64-invented.ts')];

/** The layers with one function more, added as CONTRIBUTING says: a file, and its line in the catalogue. */
export async function layersWith(name: string, description: string): Promise<typeof Layers> {
  const text = await readFile(catalogue, 'utf8');
  const added = text.replace('\n] as const;', `\n  ${name},\n] as const;`);
  if (added === text) throw new Error('the catalogue is not where it was');
  const files: Readonly<Record<string, string>> = {
    [catalogue]: `import { ${name} } from './64-invented.ts';\n${added}`,
    [invented]: description,
  };
  const plugin: Plugin = {
    name: 'added-function',
    enforce: 'pre',
    resolveId: { filter: { id: /64-invented/ }, handler: () => invented },
    load: { filter: { id: /functions.(index|64-invented)\.ts$/ }, handler: (id) => files[resolve(id)] },
  };
  const built = await build({
    configFile: false,
    logLevel: 'error',
    plugins: [plugin],
    build: {
      write: false,
      minify: false,
      target: 'es2022',
      lib: { entry: join(import.meta.dirname, 'layers.ts'), formats: ['iife'], name: 'layers' },
    },
  });
  const [bundle] = [built].flat();
  if (bundle === undefined || !('output' in bundle)) throw new Error('not built');
  return runInThisContext(`(() => { ${bundle.output[0].code}\nreturn layers; })()`);
}

/** The example of CONTRIBUTING, to the letter. */
export async function exampleOfContributing(): Promise<string> {
  const text = await readFile(join(root, 'CONTRIBUTING.md'), 'utf8');
  const example = /```ts\n(import [^`]*export const writeRecipe = [^`]*)```/.exec(text)?.[1];
  if (example === undefined) throw new Error('CONTRIBUTING has no example of a description');
  return example;
}
