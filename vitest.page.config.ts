import { availableParallelism } from 'node:os';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';
import { licences } from './scripts/licences.mjs';

/** The tests that draw the page in their own process, written for Playwright. */
export default defineConfig({
  cacheDir: '.cache/vitest-page',
  plugins: [licences()],
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  resolve: { alias: { '@playwright/test': fileURLToPath(new URL('tests/page/page.ts', import.meta.url)) } },
  test: {
    include: ['tests/page/**/*.spec.ts'],
    globalSetup: 'tests/page/drawn/build-workers.ts',
    environment: 'node',
    maxWorkers: availableParallelism(),
    // For what does not end.
    testTimeout: 300_000,
    hookTimeout: 300_000,
    isolate: false,
    // A page that is loaded again begins with nothing: what keeps state is read anew with it.
    server: { deps: { inline: [/preact/, /idb-keyval/, /uplot/] } },
  },
});
