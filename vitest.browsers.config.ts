import { defineConfig } from 'vitest/config';

/** `npm run browsers`: the same steps in every browser that is installed, on the page as last built. */
export default defineConfig({
  cacheDir: '.cache/vitest',
  test: {
    include: ['tests/browsers/**/*.test.ts'],
    environment: 'node',
    testTimeout: 120_000,
    hookTimeout: 120_000,
  },
});
