import { defineConfig } from '@playwright/test';
import base from './playwright.config.ts';
import { chooserArgs } from './tests/serial/harness/chooser.ts';

const { launchOptions, ...use } = base.use ?? {};

/** The tests of the real Web Serial API: `scripts/serial-tests.mjs` runs them where serial ports can be plugged in. */
export default defineConfig({
  ...base,
  testDir: 'tests/serial',
  outputDir: '.cache/playwright-serial',
  // The chooser's port is one, and so is the list of adapters.
  workers: 1,
  use: { ...use, launchOptions: { ...launchOptions, args: [...(launchOptions?.args ?? []), ...chooserArgs] } },
});
