// `npm run browsers`: every step of `tests/browsers` in every browser that is installed, on the page as last built.
import { findInstalledBrowser } from './find-browser.mjs';
import { howToGetTheOthers, prepareOtherBrowsers } from './other-browsers.mjs';
import { run } from './run.mjs';

const { env, missing } = await prepareOtherBrowsers();
if (missing.length > 0) console.error(`NOT RUN IN ${missing.join(' AND ')}. ${howToGetTheOthers}`);
const chromium = findInstalledBrowser();
process.exitCode = await run(
  process.execPath,
  ['node_modules/vitest/vitest.mjs', 'run', '--config', 'vitest.browsers.config.ts', ...process.argv.slice(2)],
  { env: { BROWSERS: process.env.BROWSERS ?? 'all', ...env, ...(chromium && { FRAMEWRIGHT_BROWSER: chromium }) } },
);
