import { availableParallelism } from 'node:os';
import { defineConfig } from 'vitest/config';

export default defineConfig({
  cacheDir: '.cache/vitest',
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  test: {
    include: ['tests/unit/**/*.test.{ts,tsx}'],
    setupFiles: ['tests/unit/seed.ts'],
    environment: 'node',
    // By itself Vitest leaves one processor idle.
    maxWorkers: availableParallelism(),
    // For what does not end. A machine with other work to do is no fault of the code.
    testTimeout: 300_000,
    hookTimeout: 300_000,
    // No test changes what another imports, and modules below the page keep nothing (`layering/module-state.test.ts`), so that
    // files need no module graph of their own.
    isolate: false,
    execArgv: ['--max-semi-space-size=64'],
  },
});
