import { readdir, rm } from 'node:fs/promises';
import { join } from 'node:path';
import { defineConfig, type Plugin } from 'vite';
import { policyOfFolder } from './scripts/content-security-policy.mjs';
import { licences } from './scripts/licences.mjs';
import { offline } from './scripts/offline/plugin.ts';

/** Empties dist/ before the page is built, but for the library in dist/lib, which has a build of its own. */
function emptyPageOutput(): Plugin {
  let outDir = '';
  return {
    name: 'empty-page-output',
    apply: 'build',
    configResolved(config) {
      outDir = config.build.outDir;
    },
    async buildStart() {
      const names = await readdir(outDir).catch(() => []);
      const stale = names.filter((name) => name !== 'lib');
      await Promise.all(stale.map((name) => rm(join(outDir, name), { recursive: true })));
    },
  };
}

/** Writes the policy into the page, so that every host serves it; while developing, Vite's own scripts would break it. */
function writePolicy(): Plugin {
  return {
    name: 'content-security-policy',
    apply: 'build',
    transformIndexHtml: () => [
      {
        tag: 'meta',
        attrs: { 'http-equiv': 'Content-Security-Policy', content: policyOfFolder },
        injectTo: 'head-prepend',
      },
    ],
  };
}

export default defineConfig({
  base: './',
  // One page, and no address but its own: a missing file is answered with 404, not with the page.
  appType: 'mpa',
  cacheDir: '.cache/vite',
  plugins: [emptyPageOutput(), writePolicy(), licences(), offline()],
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  // Workers are modules too, and keep the tables of the CRC as constants like the rest of the page.
  // Each is one file: WebKit runs a worker's own file a second time where a part of it that comes later imports it.
  worker: { format: 'es', rolldownOptions: { output: { topLevelVar: false, codeSplitting: false } } },
  build: {
    target: 'es2022',
    outDir: 'dist',
    emptyOutDir: false,
    modulePreload: { polyfill: false },
    manifest: 'manifest.json',
    rolldownOptions: {
      output: {
        topLevelVar: false,
        // The first file names all others: a kilobyte of it would be their names. `manifest.json` says which is which.
        entryFileNames: 'assets/[name]-[hash:7].js',
        chunkFileNames: 'assets/[hash:7].js',
        assetFileNames: 'assets/[hash:7][extname]',
        hashCharacters: 'hex',
        // What the page loads at first is one file: cut along what later chunks share, it weighs a tenth more.
        codeSplitting: {
          groups: [
            { name: 'first', tags: ['$initial'] },
            // Loaded together soon after: two files would weigh a tenth of a kilobyte more.
            { name: 'kept', test: /worker-script|offline.offline/ },
          ],
        },
      },
    },
  },
});
