import { defineConfig, devices } from '@playwright/test';
import { findBrowserWithoutWindows } from './scripts/find-browser.mjs';

/** Two checkouts that are tested at the same time each need a port of their own. */
const port = Number(process.env['FRAMEWRIGHT_PORT'] ?? 43951);
const executablePath = findBrowserWithoutWindows();
const asRoot = process.getuid?.() === 0;

/**
 * Features of the browser that the tests have no use for. The last such list holds, so that this one repeats what of
 * Playwright's own keeps the browser off the network and draws pages at once.
 */
const withoutFeatures = [
  // Chromium draws its address bar's menu as two pages of their own for each window, at the cost of a page of ours.
  'WebUIOmniboxPopup',
  'WebUIOmniboxAimPopup',
  'AimEnabled',
  'DestroyProfileOnBrowserClose',
  'HttpsUpgrades',
  'HttpsFirstBalancedModeAutoEnable',
  'LensOverlay',
  'MediaRouter',
  'NetworkTimeServiceQuerying',
  'OptimizationHints',
  'PaintHolding',
  'PreconnectToSearch',
  'ThirdPartyStoragePartitioning',
];

/** The tests run against the built page: `npm run build` comes first. */
export default defineConfig({
  testDir: 'tests/browser',
  outputDir: '.cache/playwright',
  // It is JavaScript, and large.
  build: { external: ['**/.cache/known/**'] },
  workers: 2,
  fullyParallel: true,
  forbidOnly: Boolean(process.env['CI']),
  // For what never comes: a machine with other work to do is no fault of the page.
  timeout: 180_000,
  expect: { timeout: 60_000 },
  // A server has nobody who runs it again; what passed only then is named in the summary of `npm test`.
  retries: process.env['CI'] ? 1 : 0,
  reporter: 'list',
  use: {
    ...devices['Desktop Chrome'],
    baseURL: `http://127.0.0.1:${port}/`,
    // A page of its own for each test costs as much again as what the test does. A test that fails ends its browser, so
    // that what it left behind harms none after it; one permission for all, because another one is another page.
    reuseContext: true,
    // A page that is kept asks the network for nothing that a test could keep away; `offline.spec.ts` allows it.
    serviceWorkers: 'block',
    permissions: ['clipboard-read', 'clipboard-write'],
    // Recording every test costs more time than the tests.
    trace: 'off',
    launchOptions: {
      // Without a path, Playwright takes the browser from its own cache.
      ...(executablePath === undefined ? {} : { executablePath }),
      args: [
        ...(asRoot ? ['--no-sandbox'] : []),
        '--disable-background-networking',
        '--disable-component-update',
        '--disable-sync',
        '--no-first-run',
        '--disable-quic',
        `--disable-features=${withoutFeatures.join(',')}`,
      ],
    },
  },
  webServer: {
    command: `node scripts/static-server.mjs ${port}`,
    url: `http://127.0.0.1:${port}/`,
    reuseExistingServer: false,
  },
});
