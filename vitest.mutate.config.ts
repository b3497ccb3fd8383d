import { defineConfig } from 'vitest/config';

export default defineConfig({
  cacheDir: '.cache/vitest',
  oxc: { jsx: { runtime: 'automatic', importSource: 'preact' } },
  test: {
    // Of the folder that the script names.
    include: ['**/*.test.{ts,tsx}'],
    exclude: [
      '**/layering/**',
      '**/*properties.test.ts',
      '**/*exhaustive.test.ts',
      '**/{vectors,broken-frames,rtu-scan}.test.ts',
      '**/{split-stream,compare-damage,user-frames}.test.ts',
    ],
    environment: 'node',
    testTimeout: 30_000,
    // A mutant in what a module works out when it is loaded shows only where it is loaded again.
    isolate: true,
  },
});
