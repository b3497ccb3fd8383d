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
  if (!report) return outcome(0, 1, 0, code);
  /** @type {{ status: string, assertionResults: unknown[] }[]} */
  const files = report.testResults;
  const notLoaded = files.filter((file) => file.status === 'failed' && file.assertionResults.length === 0).length;
  const skipped = report.numPendingTests + report.numTodoTests;
  return outcome(report.numPassedTests, report.numFailedTests + notLoaded, skipped, code);
}

/**
 * @param {string} path a report of Playwright's reporter "json"
 * @param {number} code Playwright's exit code
 * @returns {Outcome}
 */
export function readPlaywrightReport(path, code) {
  const stats = read(path)?.stats;
  return stats ? outcome(stats.expected, stats.unexpected + stats.flaky, stats.skipped, code) : outcome(0, 1, 0, code);
}

/**
 * A run that went wrong as a whole, or in which no test passed, counts as one failure even if no test failed.
 * @param {number} passed
 * @param {number} failed
 * @param {number} skipped
 * @param {number} code
 * @returns {Outcome}
 */
function outcome(passed, failed, skipped, code) {
  const failures = Math.max(failed, code === 0 && passed > 0 ? 0 : 1);
  return { passed, failed: failures, ...(skipped > 0 ? { note: `${skipped} skipped` } : {}) };
}

/** @param {string} path */
function read(path) {
  try {
    return JSON.parse(readFileSync(path, 'utf8'));
  } catch {
    return undefined;
  }
}
