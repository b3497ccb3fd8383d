import { availableParallelism } from 'node:os';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vitest/config';

/** The tests that draw the page in their own process, written for Playwright. */
export default defineConfig({
  cacheDir: '.cache/vitest-page',
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  resolve: { alias: { '@playwright/test': fileURLToPath(new URL('tests/page/page.ts', import.meta.url)) } },
  test: {
    include: ['tests/page/**/*.spec.ts'],
    globalSetup: 'scripts/drawn-page/build.ts',
    environment: 'node',
    maxWorkers: availableParallelism(),
    // For what does not end.
    testTimeout: 300_000,
    hookTimeout: 300_000,
    isolate: false,
    execArgv: ['--max-semi-space-size=64'],
  },
});
