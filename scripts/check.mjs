// `npm test`: install if needed, then every check there is, each of them even if one before it failed, side by side where
// there are processors for it.
// The last line counts tests; a check that is not made of tests counts as one.
import { mkdirSync, rmSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join } from 'node:path';
import { ensureInstalled } from './ensure-installed.mjs';
import { findBrowserWithoutWindows, findOrInstallBrowser, howToGetABrowser } from './find-browser.mjs';
import { howToGetTheOthers, prepareOtherBrowsers } from './other-browsers.mjs';
import { prepareProgramTools } from './programs-tools.mjs';
import { root, runScript } from './run.mjs';
import { howToGetASerialRig, prepareSerialRig } from './serial-rig.mjs';
import { readPlaywrightReport, readVitestReport } from './test-reports.mjs';

/**
 * What can be told of a step while others run beside it: its output, which is shown when it ends.
 * @typedef {(text: string) => void} Tell
 * @typedef {import('./test-reports.mjs').Outcome} Outcome
 * @typedef {{ name: string, cores: number, after?: string, run: (tell: Tell) => Promise<Outcome> }} Step
 * @typedef {Outcome & { name: string, output: string, seconds: number }} Row
 */

const cache = join(root, '.cache');

/**
 * Begun in this order as soon as there are processors for them, and what they need is there: what takes longest first. The tests with serial
 * ports wait for the line most of the time, so that they run beside anything. Building the page empties its folder, so that what
 * else comes into it is built later.
 * @type {Step[]}
 */
const steps = [
  { name: 'build the page', cores: 1, run: script('build') },
  { name: 'build the one file', cores: 1, after: 'build the page', run: script('build:file') },
  { name: 'browser with serial ports', cores: 0, after: 'build the page', run: serialTests },
  { name: 'browser', cores: 2, after: 'build the one file', run: browserTests },
  { name: 'unit, properties, layering', cores: 2, run: unitTests },
  { name: 'page without a browser', cores: 2, run: (tell) => vitest('page', tell) },
  // In threads of its own it takes twice the work, and other steps keep the processors busy.
  { name: 'types', cores: 1, run: script('types', ['--singleThreaded']) },
  { name: 'lint and format', cores: 1, run: script('lint') },
  { name: 'build the library', cores: 1, after: 'build the page', run: script('build:lib') },
  { name: 'package', cores: 1, after: 'build the library', run: packageTests },
  { name: 'findings in damaged frames', cores: 1, after: 'build the library', run: damagedFrames },
  { name: 'size of what is loaded', cores: 0, after: 'build the page', run: checkSize },
  { name: 'other browsers', cores: 1, after: 'build the one file', run: otherBrowserTests },
  { name: 'programs', cores: 2, run: programTests },
];

/** A step waits now and then, for a page, a timer or its last file: so many more than there are processors keep them all at work. */
const BESIDE = 2;

/** Of a step that failed and names no test, so many lines are repeated at the end. */
const LINES_OF_A_STEP = 15;

/** @type {Promise<string | undefined> | undefined} */
let found;

await ensureInstalled();
mkdirSync(cache, { recursive: true });
// Nothing below may pass on the strength of an earlier build.
rmSync(join(root, 'dist'), { recursive: true, force: true });

const begun = performance.now();
const rows = await runAll(steps, availableParallelism() + BESIDE);

console.log(`\n── summary ${'─'.repeat(63)}`);
for (const { name, passed, failed, note, seconds } of rows) {
  const verdict = failed > 0 ? 'FAILED' : passed > 0 ? 'ok' : 'NOT RUN';
  const counts = `${String(passed).padStart(5)} passed ${String(failed).padStart(3)} failed`;
  console.log(
    `${verdict.padEnd(8)} ${name.padEnd(28)} ${counts} ${seconds.toFixed(1).padStart(6)} s  ${note ?? ''}`.trimEnd(),
  );
}
console.log(`${' '.repeat(9)}${'all, some side by side'.padEnd(54)}${secondsSince(begun).toFixed(1).padStart(6)} s`);
const passed = rows.reduce((sum, row) => sum + row.passed, 0);
const failed = rows.reduce((sum, row) => sum + row.failed, 0);
process.exitCode = failed === 0 ? 0 : 1;
// Last, so that the end of a log says which tests to look at.
const said = rows.flatMap(complaintsOf);
if (said.length > 0) console.log(`\n${said.join('\n')}`);
console.log(`\n${passed} passed, ${failed} failed`);

/**
 * What failed in a step, a test each; of one that failed without naming a test, the end of its output.
 * @param {Row} row
 * @returns {string[]}
 */
function complaintsOf({ name, failed, complaints = [], output }) {
  /** @type {(line: string) => string} */
  const indent = (line) => `        ${line}`;
  const lines = complaints.flatMap(({ where, why, flaky }) => [
    `${flaky ? 'FLAKY ' : 'FAILED'}  ${name}: ${where}`,
    ...why.map(indent),
  ]);
  if (failed === 0 || complaints.some(({ flaky }) => !flaky)) return lines;
  const end = output.trimEnd().split('\n').slice(-LINES_OF_A_STEP);
  return [...lines, `FAILED  ${name}; its output ends:`, ...end.map(indent)];
}

/** @param {number} begin */
function secondsSince(begin) {
  return (performance.now() - begin) / 1000;
}

/**
 * Every step, side by side as far as there is room; one that needs more than there is runs by itself.
 * @param {readonly Step[]} all
 * @param {number} cores
 */
async function runAll(all, cores) {
  /** @type {Map<string, Row>} */
  const done = new Map();
  const waiting = [...all];
  const running = new Set();
  let used = 0;
  /** @param {Step} step */
  const start = async (step) => {
    const begin = performance.now();
    let output = '';
    const outcome = await step
      .run((text) => {
        output += text;
      })
      .catch((error) => {
        output += `${error?.stack ?? error}\n`;
        return /** @type {Outcome} */ ({ passed: 0, failed: 1 });
      });
    console.log(`\n── ${step.name} ${'─'.repeat(70 - step.name.length)}`);
    if (output !== '') console.log(output.trimEnd());
    done.set(step.name, { name: step.name, ...outcome, output, seconds: secondsSince(begin) });
    used -= step.cores;
  };
  while (waiting.length > 0 || running.size > 0) {
    // What could begin but for the room is not kept from it by what is behind it.
    let isFull = false;
    for (const step of [...waiting]) {
      if (step.after !== undefined && !done.has(step.after)) continue;
      isFull ||= step.cores > 0 && used > 0 && used + step.cores > cores;
      if (isFull && step.cores > 0) continue;
      waiting.splice(waiting.indexOf(step), 1);
      used += step.cores;
      const end = start(step).finally(() => running.delete(end));
      running.add(end);
    }
    await Promise.race(running);
  }
  return all.flatMap(({ name }) => done.get(name) ?? []);
}

/**
 * A script that passes or fails as a whole.
 * @param {string} name
 * @param {string[]} [args]
 * @param {{ env?: Record<string, string> }} [options]
 * @returns {Step['run']}
 */
function script(name, args = [], options = {}) {
  return async (tell) =>
    (await runScript(name, args, { ...options, tell })) === 0 ? { passed: 1, failed: 0 } : { passed: 0, failed: 1 };
}

/** @type {Step['run']} */
async function unitTests(tell) {
  return vitest('unit', tell);
}

/** @type {Step['run']} */
async function programTests(tell) {
  const missing = Object.values(await prepareProgramTools());
  const outcome = await vitest('programs', tell);
  if (missing.length === 0) return outcome;
  const absent = notRun(tell, 'SOME PROGRAMS', missing.join('\n'), 'some not run: see above what is missing');
  return { ...outcome, ...absent, passed: outcome.passed, failed: Math.max(outcome.failed, absent.failed) };
}

/** A few steps in each browser; `npm run browsers` goes all of them. */
/** @type {Step['run']} */
async function otherBrowserTests(tell) {
  const chromium = await findBrowser();
  const { env, missing } = await prepareOtherBrowsers();
  const own = chromium && { FRAMEWRIGHT_BROWSER: findBrowserWithoutWindows() ?? chromium };
  const outcome = await vitest('browsers', tell, { BROWSERS: 'some', ...env, ...own });
  if (missing.length === 0) return outcome;
  const absent = notRun(tell, missing.join(' AND ').toUpperCase(), howToGetTheOthers, 'some not run: see above');
  return { ...outcome, ...absent, passed: outcome.passed, failed: Math.max(outcome.failed, absent.failed) };
}

/**
 * @param {string} name
 * @param {Tell} tell
 * @param {Record<string, string>} [env]
 */
async function vitest(name, tell, env = {}) {
  const report = join(cache, `${name}.json`);
  rmSync(report, { force: true });
  const args = ['--reporter=default', '--reporter=json', `--outputFile.json=${report}`];
  return readVitestReport(report, await runScript(name, args, { env, tell }));
}

/** @type {Step['run']} */
async function damagedFrames(tell) {
  const env = { BUILT: '1', CASES: '80' };
  return script('bench:diagnose', ['--check'], { env })(tell);
}

/** @type {Step['run']} */
async function packageTests(tell) {
  const { checkPackage } = await import('./package-check.mjs');
  return checkPackage(tell);
}

/** @type {Step['run']} */
async function checkSize(tell) {
  const browser = await findBrowser();
  if (browser === undefined) return notRun(tell, 'SIZE OF WHAT IS LOADED', howToGetABrowser, 'no browser');
  const { sizeFits } = await import('./size-budget.mjs');
  return (await sizeFits(tell, browser)) ? { passed: 1, failed: 0 } : { passed: 0, failed: 1 };
}

/** Both kinds of browser tests look for one, or have one installed; it is looked for once. */
function findBrowser() {
  found ??= findOrInstallBrowser();
  return found;
}

/** @type {Step['run']} */
async function browserTests(tell) {
  const any = await findBrowser();
  if (any === undefined) return notRun(tell, 'BROWSER TESTS', howToGetABrowser, 'no browser: see above how to get one');
  const browser = findBrowserWithoutWindows() ?? any;
  tell(`with ${browser}\n`);
  return playwright('browser', browser, tell);
}

/** @type {Step['run']} */
async function serialTests(tell) {
  const browser = await findBrowser();
  const missing = browser === undefined ? 'There is no browser.' : await prepareSerialRig();
  if (browser === undefined || missing !== undefined) {
    return notRun(tell, 'TESTS WITH SERIAL PORTS', `${missing}\n${howToGetASerialRig}`, 'see above what is missing');
  }
  return playwright('serial', browser, tell);
}

/**
 * @param {string} name
 * @param {string} path
 * @param {Tell} tell
 */
async function playwright(name, path, tell) {
  const report = join(cache, `${name}.json`);
  rmSync(report, { force: true });
  const env = { FRAMEWRIGHT_BROWSER: path, PLAYWRIGHT_JSON_OUTPUT_FILE: report };
  return readPlaywrightReport(report, await runScript(name, ['--reporter=list,json'], { env, tell }));
}

/**
 * What cannot run here says so, and on a server it fails.
 * @param {Tell} tell
 * @param {string} what
 * @param {string} why
 * @param {string} note
 * @returns {Outcome}
 */
function notRun(tell, what, why, note) {
  tell(`${what} NOT RUN. ${why}\n`);
  const onServer = !['', '0', 'false'].includes(process.env.CI ?? '');
  return { passed: 0, failed: onServer ? 1 : 0, note };
}
