import { readFileSync } from 'node:fs';

/**
 * What a step of the checks came to.
 * @typedef {{ passed: number, failed: number, note?: string }} Outcome
 */

/**
 * @param {string} path a report of vitest's reporter "json"
 * @param {number} code vitest's exit code
 * @returns {Outcome}
 */
export function readVitestReport(path, code) {
  const report = read(path);
  return outcome(report?.numPassedTests, report?.numFailedTests, report?.numPendingTests + report?.numTodoTests, code);
}

/**
 * @param {string} path a report of Playwright's reporter "json"
 * @param {number} code Playwright's exit code
 * @returns {Outcome}
 */
export function readPlaywrightReport(path, code) {
  const stats = read(path)?.stats;
  return outcome(stats?.expected, stats?.unexpected + stats?.flaky, stats?.skipped, code);
}

/**
 * A run that failed without a failed test (a file that could not be loaded, say) counts as one failure.
 * @param {number | undefined} passed
 * @param {number | undefined} failed
 * @param {number | undefined} skipped
 * @param {number} code
 * @returns {Outcome}
 */
function outcome(passed = 0, failed = 0, skipped = 0, code) {
  const failures = Math.max(failed || 0, code === 0 && passed > 0 ? 0 : 1);
  return { passed, failed: failures, ...(skipped ? { note: `${skipped} skipped` } : {}) };
}

/** @param {string} path */
function read(path) {
  try {
    return JSON.parse(readFileSync(path, 'utf8'));
  } catch {
    return undefined;
  }
}
