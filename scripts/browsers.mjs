// `npm run browsers`: every step of `tests/browsers` in every browser that is installed, on the page as last built, and serial
// ports in Firefox.
import { findInstalledBrowser } from './find-browser.mjs';
import { howToGetTheOthers, prepareOtherBrowsers } from './other-browsers.mjs';
import { run } from './run.mjs';
import { howToGetASerialRig, inNamespaces, prepareSerialRig, serialEnvironment } from './serial-rig.mjs';

const { env, missing } = await prepareOtherBrowsers();
if (missing.length > 0) console.error(`NOT RUN IN ${missing.join(' AND ')}. ${howToGetTheOthers}`);
const chromium = findInstalledBrowser();
const vitest = [
  'node_modules/vitest/vitest.mjs',
  'run',
  '--config',
  'vitest.browsers.config.ts',
  ...process.argv.slice(2),
];
const which = process.env.BROWSERS ?? 'all';
const steps = await run(process.execPath, vitest, {
  env: { BROWSERS: which, ...env, ...(chromium && { FRAMEWRIGHT_BROWSER: chromium }) },
});
process.exitCode = steps || (which === 'all' && env.FRAMEWRIGHT_FIREFOX ? await serialPortsInFirefox() : 0);

async function serialPortsInFirefox() {
  const lacking = await prepareSerialRig();
  if (lacking !== undefined) {
    console.error(`SERIAL PORTS IN FIREFOX NOT RUN. ${lacking}\n${howToGetASerialRig}`);
    return 0;
  }
  const [command, args] = inNamespaces([process.execPath, ...vitest]);
  return run(command, args, { env: { ...env, ...serialEnvironment } });
}
