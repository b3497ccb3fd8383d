// `npm test`: install if needed, then every check there is, each of them even if one before it failed.
// The last line counts tests; a check that is not made of tests counts as one.
import { mkdirSync, rmSync } from 'node:fs';
import { join } from 'node:path';
import { ensureInstalled } from './ensure-installed.mjs';
import { findOrInstallBrowser, howToGetABrowser } from './find-browser.mjs';
import { root, runScript } from './run.mjs';
import { howToGetASerialRig, prepareSerialRig } from './serial-rig.mjs';
import { readPlaywrightReport, readVitestReport } from './test-reports.mjs';

/**
 * @typedef {import('./test-reports.mjs').Outcome} Outcome
 * @typedef {{ name: string, run: () => Promise<Outcome> }} Step
 */

const cache = join(root, '.cache');

/** @type {Step[]} */
const steps = [
  { name: 'types', run: () => single(runScript('types')) },
  { name: 'lint and format', run: () => single(runScript('lint')) },
  { name: 'unit, properties, layering', run: unitTests },
  { name: 'build the page', run: () => single(runScript('build')) },
  { name: 'build the library', run: () => single(runScript('build:lib')) },
  { name: 'size of the first load', run: checkSize },
  { name: 'browser', run: browserTests },
  { name: 'browser with serial ports', run: serialTests },
];

await ensureInstalled();
mkdirSync(cache, { recursive: true });
// Nothing below may pass on the strength of an earlier build.
rmSync(join(root, 'dist'), { recursive: true, force: true });

const rows = [];
for (const { name, run } of steps) {
  console.log(`\n── ${name} ${'─'.repeat(70 - name.length)}`);
  const begin = performance.now();
  const outcome = await run().catch((error) => {
    console.error(error);
    return /** @type {Outcome} */ ({ passed: 0, failed: 1 });
  });
  rows.push({ name, ...outcome, seconds: (performance.now() - begin) / 1000 });
}

console.log(`\n── summary ${'─'.repeat(63)}`);
for (const { name, passed, failed, note, seconds } of rows) {
  const verdict = failed > 0 ? 'FAILED' : passed > 0 ? 'ok' : 'NOT RUN';
  const counts = `${String(passed).padStart(5)} passed ${String(failed).padStart(3)} failed`;
  console.log(
    `${verdict.padEnd(8)} ${name.padEnd(28)} ${counts} ${seconds.toFixed(1).padStart(6)} s  ${note ?? ''}`.trimEnd(),
  );
}
const passed = rows.reduce((sum, row) => sum + row.passed, 0);
const failed = rows.reduce((sum, row) => sum + row.failed, 0);
process.exitCode = failed === 0 ? 0 : 1;
console.log(`\n${passed} passed, ${failed} failed`);

/**
 * A check that passes or fails as a whole.
 * @param {Promise<number>} code
 * @returns {Promise<Outcome>}
 */
async function single(code) {
  return (await code) === 0 ? { passed: 1, failed: 0 } : { passed: 0, failed: 1 };
}

async function unitTests() {
  const report = join(cache, 'unit.json');
  rmSync(report, { force: true });
  const code = await runScript('unit', ['--reporter=default', '--reporter=json', `--outputFile.json=${report}`]);
  return readVitestReport(report, code);
}

/** @returns {Promise<Outcome>} */
async function checkSize() {
  const { sizeFits } = await import('./size-budget.mjs');
  return sizeFits() ? { passed: 1, failed: 0 } : { passed: 0, failed: 1 };
}

/** @returns {Promise<Outcome>} */
async function browserTests() {
  const browser = await findOrInstallBrowser();
  if (browser === undefined) return notRun('BROWSER TESTS', howToGetABrowser, 'no browser: see above how to get one');
  console.log(`with ${browser}`);
  return playwright('browser', browser);
}

/** @returns {Promise<Outcome>} */
async function serialTests() {
  const browser = await findOrInstallBrowser();
  const missing = browser === undefined ? 'There is no browser.' : await prepareSerialRig();
  if (browser === undefined || missing !== undefined) {
    return notRun('TESTS WITH SERIAL PORTS', `${missing}\n${howToGetASerialRig}`, 'see above what is missing');
  }
  return playwright('serial', browser);
}

/**
 * @param {string} script
 * @param {string} browser
 */
async function playwright(script, browser) {
  const report = join(cache, `${script}.json`);
  rmSync(report, { force: true });
  const env = { FRAMEWRIGHT_BROWSER: browser, PLAYWRIGHT_JSON_OUTPUT_FILE: report };
  const code = await runScript(script, ['--reporter=list,json'], { env });
  return readPlaywrightReport(report, code);
}

/**
 * What cannot run here says so, and on a server it fails.
 * @param {string} what
 * @param {string} why
 * @param {string} note
 * @returns {Outcome}
 */
function notRun(what, why, note) {
  console.error(`${what} NOT RUN. ${why}`);
  const onServer = !['', '0', 'false'].includes(process.env.CI ?? '');
  return { passed: 0, failed: onServer ? 1 : 0, note };
}
