import { readdirSync, rmSync } from 'node:fs';
import { basename, join } from 'node:path';
import { build, type InlineConfig, type Plugin } from 'vite';
import { builtFolder, pages } from '../../tests/page/drawn/built.ts';
import { licences } from '../licences.mjs';

const workers = 'src/ui/parts/workers';

/** Builds the page as scripts that Node runs, and its workers as Node's threads can run them. */
export async function setup(): Promise<void> {
  rmSync(builtFolder, { recursive: true, force: true });
  const files = readdirSync(workers).filter((name) => name.endsWith('-worker.ts'));
  await build(
    config('es', Object.fromEntries(files.map((name) => [basename(name, '.ts'), join(workers, name)])), 'mjs'),
  );
  for (const [file, script] of Object.entries(pages)) {
    await build(config('iife', { [file]: `drawn:${script}` }, 'js'));
  }
}

const config = (format: 'es' | 'iife', entry: Record<string, string>, ending: string): InlineConfig => ({
  configFile: false,
  publicDir: false,
  logLevel: 'error',
  plugins: [licences(), drawn()],
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  define: { 'import.meta.env.PROD': 'false' },
  build: {
    outDir: builtFolder,
    emptyOutDir: false,
    minify: false,
    target: 'node20',
    modulePreload: false,
    lib: { entry, formats: [format], name: 'page', fileName: (_, name) => `${name}.${ending}` },
  },
});

/** The page, what a test does before it, and how to end it; the address of a worker is the name of its file. */
function drawn(): Plugin {
  return {
    name: 'drawn',
    enforce: 'pre',
    resolveId: (source) => (/drawn:|-worker\.ts\?worker&url$/.test(source) ? `\0${source}` : undefined),
    load(id) {
      const worker = /^\0.*?([\w-]+)\.ts\?worker&url$/.exec(id)?.[1];
      if (worker) return `export default '/${worker}.mjs'`;
      const script = /drawn:(.*)$/.exec(id)?.[1];
      if (script === undefined) return undefined;
      if (script === 'first') {
        return `
          import { languages } from '/src/words/index.ts';
          globalThis.beforePage?.(languages);
        `;
      }
      return `
        import { render } from 'preact';
        import 'drawn:first';
        import '/${script}';
        globalThis.endPage = () => render(null, document.getElementById('app'));
      `;
    },
  };
}
