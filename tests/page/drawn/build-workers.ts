import { readdirSync } from 'node:fs';
import { basename, join } from 'node:path';
import { build } from 'vite';
import { workersFolder } from './workers-folder.ts';

const from = 'src/ui/parts/workers';

/** The page's workers as Node's threads can run them. */
export async function setup(): Promise<void> {
  const files = readdirSync(from).filter((name) => name.endsWith('-worker.ts'));
  await build({
    configFile: false,
    logLevel: 'error',
    publicDir: false,
    build: {
      outDir: workersFolder,
      emptyOutDir: true,
      minify: false,
      target: 'node20',
      modulePreload: false,
      lib: {
        entry: Object.fromEntries(files.map((name) => [basename(name, '.ts'), join(from, name)])),
        formats: ['es'],
        fileName: (_, name) => `${name}.mjs`,
      },
    },
  });
}
