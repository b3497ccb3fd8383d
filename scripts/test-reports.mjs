import { readFileSync } from 'node:fs';
import { relative, sep } from 'node:path';
import { stripVTControlCharacters } from 'node:util';
import { root } from './run.mjs';

/**
 * What a step of the checks came to. A test that failed and passed when it was run again is flaky, and has passed.
 * @typedef {{ where: string, why: string[], flaky?: boolean }} Complaint where: file › test; why: how the error begins
 * @typedef {{ passed: number, failed: number, note?: string, complaints?: Complaint[] }} Outcome
 */

/** What was expected and what was there, below the error's name. */
const LINES_OF_AN_ERROR = 5;

/**
 * @param {string} path a report of vitest's reporter "json"
 * @param {number} code vitest's exit code
 * @returns {Outcome}
 */
export function readVitestReport(path, code) {
  const report = read(path);
  if (!report) return outcome([], 0, 1, 0, code);
  /** @type {{ name: string, status: string, message: string, assertionResults: VitestResult[] }[]} */
  const files = report.testResults;
  const notLoaded = files.filter((file) => file.status === 'failed' && file.assertionResults.length === 0);
  const complaints = notLoaded.map(({ name, message }) => complaint([fromRoot(name)], message));
  for (const { name, assertionResults } of files) {
    for (const { status, ancestorTitles, title, failureMessages } of assertionResults) {
      if (status !== 'failed') continue;
      complaints.push(complaint([fromRoot(name), ...ancestorTitles, title], failureMessages[0]));
    }
  }
  const skipped = report.numPendingTests + report.numTodoTests;
  return outcome(complaints, report.numPassedTests, report.numFailedTests + notLoaded.length, skipped, code);
}

/** @typedef {{ status: string, ancestorTitles: string[], title: string, failureMessages: string[] }} VitestResult */

/**
 * @param {string} path a report of Playwright's reporter "json"
 * @param {number} code Playwright's exit code
 * @returns {Outcome}
 */
export function readPlaywrightReport(path, code) {
  const report = read(path);
  if (!report?.stats) return outcome([], 0, 1, 0, code);
  const { expected, unexpected, flaky, skipped } = report.stats;
  const complaints = [
    ...inSuites(report.suites, []),
    // What belongs to no test, such as a server that does not start.
    ...report.errors.map((/** @type {PlaywrightError} */ error) => complaint(['Playwright'], error.message)),
  ];
  return outcome(complaints, expected + flaky, unexpected, skipped, code);
}

/**
 * @typedef {{ message?: string }} PlaywrightError
 * @typedef {{ status: string, results: { errors: PlaywrightError[] }[] }} PlaywrightTest
 * @typedef {{ file: string, title: string, suites?: Suite[], specs: { title: string, tests: PlaywrightTest[] }[] }} Suite
 */

/**
 * What failed in these suites, and in those inside of them.
 * @param {readonly Suite[]} suites
 * @param {readonly string[]} above titles; the first is a file's
 * @returns {Complaint[]}
 */
function inSuites(suites, above) {
  return suites.flatMap((suite) => {
    const titles = [...above, suite.title];
    const here = suite.specs.flatMap(({ title, tests }) =>
      tests
        .filter(({ status }) => status === 'unexpected' || status === 'flaky')
        .map(({ status, results }) => ({
          ...complaint([...titles, title], results.flatMap(({ errors }) => errors)[0]?.message),
          flaky: status === 'flaky',
        })),
    );
    return [...here, ...inSuites(suite.suites ?? [], titles)];
  });
}

/**
 * @param {readonly string[]} where file, groups, test
 * @param {string | undefined} message
 * @returns {Complaint}
 */
export function complaint(where, message = '') {
  const lines = stripVTControlCharacters(message)
    .split('\n')
    .map((line) => line.trim())
    // Lines of the stack and of the source say less.
    .filter((line) => line !== '' && !/^(at |(> )?\d* *\|)/.test(line));
  return { where: where.join(' › '), why: lines.slice(0, LINES_OF_AN_ERROR) };
}

/** @param {string} path */
function fromRoot(path) {
  return relative(root, path).split(sep).join('/');
}

/**
 * A run that went wrong as a whole, or in which no test passed, counts as one failure even if no test failed.
 * @param {Complaint[]} complaints
 * @param {number} passed
 * @param {number} failed
 * @param {number} skipped
 * @param {number} code
 * @returns {Outcome}
 */
function outcome(complaints, passed, failed, skipped, code) {
  const failures = Math.max(failed, code === 0 && passed > 0 ? 0 : 1);
  const flaky = complaints.filter((one) => one.flaky).length;
  const notes = [flaky > 0 ? `${flaky} FLAKY` : [], skipped > 0 ? `${skipped} skipped` : []].flat();
  return { passed, failed: failures, complaints, ...(notes.length > 0 ? { note: notes.join(', ') } : {}) };
}

/** @param {string} path */
function read(path) {
  try {
    return JSON.parse(readFileSync(path, 'utf8'));
  } catch {
    return undefined;
  }
}
