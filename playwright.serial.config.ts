import { defineConfig } from '@playwright/test';
import base from './playwright.config.ts';
import { findInstalledBrowser } from './scripts/find-browser.mjs';
import { chooserArgs } from './tests/serial/harness/chooser.ts';

const { launchOptions, ...use } = base.use ?? {};
const executablePath = findInstalledBrowser();

/** The tests of the real Web Serial API: `scripts/serial-tests.mjs` runs them where serial ports can be plugged in. */
export default defineConfig({
  ...base,
  testDir: 'tests/serial',
  outputDir: '.cache/playwright-serial',
  // The chooser's port is one, and so is the list of adapters.
  workers: 1,
  use: {
    ...use,
    // A port that a page was given stays its own, so that each test has a page of its own.
    reuseContext: false,
    launchOptions: {
      // Chromium without windows has no Web Serial.
      ...(executablePath === undefined ? {} : { executablePath }),
      args: [...(launchOptions?.args ?? []), ...chooserArgs],
    },
  },
});
