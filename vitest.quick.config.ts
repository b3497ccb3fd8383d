import { defineConfig } from 'vitest/config';

/** Stryker, which runs these tests for each mutant (`scripts/mutate.mjs`), sets this in its workers. */
const forMutants = process.env['STRYKER_MUTATOR_WORKER'] !== undefined;
const tests = process.env['FRAMEWRIGHT_TESTS'] ?? 'tests/unit';

/** `npm run unit:quick`: the unit tests but for those that take long, each property with a few examples only. */
export default defineConfig({
  cacheDir: '.cache/vitest',
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  test: {
    include: [`${tests}/**/*.test.{ts,tsx}`],
    exclude: [
      '**/layering/**',
      '**/*properties.test.ts',
      '**/*exhaustive.test.ts',
      '**/{vectors,broken-frames,split-stream,compare-damage}.test.ts',
      '**/modbus/values/values.test.ts',
    ],
    setupFiles: ['tests/unit/few-runs.ts'],
    environment: 'node',
    testTimeout: 300_000,
    // A mutant in what a module works out when it is loaded shows only where the module is loaded again.
    isolate: forMutants,
  },
});
