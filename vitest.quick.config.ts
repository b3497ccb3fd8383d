import { defineConfig } from 'vitest/config';

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
    isolate: false,
  },
});
