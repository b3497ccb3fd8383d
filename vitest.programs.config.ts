import { availableParallelism } from 'node:os';
import { defineConfig } from 'vitest/config';

/** `npm run programs`: the programs of each target, compiled and run; `npm run programs:full` with many more requests. */
export default defineConfig({
  cacheDir: '.cache/vitest',
  test: {
    include: ['tests/programs/**/*.test.ts'],
    globalSetup: ['scripts/programs-tools.mjs'],
    environment: 'node',
    // Most of the time they wait: for compilers of other languages, and for replies.
    maxWorkers: 2 * availableParallelism(),
    testTimeout: 300_000,
    hookTimeout: 300_000,
    isolate: false,
  },
});
