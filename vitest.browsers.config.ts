import { defineConfig } from 'vitest/config';

/**
 * `npm run browsers`: the same steps in every browser that is installed, on the page as last built; and, where serial ports can be
 * plugged in, those in Firefox.
 */
const which = process.env['FRAMEWRIGHT_SERIAL'] ? 'serial' : 'browsers';

export default defineConfig({
  cacheDir: '.cache/vitest',
  test: {
    include: [`tests/browsers/${which}.test.ts`],
    environment: 'node',
    testTimeout: 300_000,
    hookTimeout: 300_000,
  },
});
