import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { installDebianPackages, onPath } from './debian.mjs';
import { runNpm } from './run.mjs';

const names = ['chromium', 'chromium-browser', 'google-chrome', 'google-chrome-stable', 'chrome', 'microsoft-edge'];

/** What is said when there is no browser to be had. */
export const howToGetABrowser = `No Chromium or Chrome was found, and none could be installed.
  Either install Chromium or Chrome the usual way (on Debian and Ubuntu as root: apt-get install chromium),
  or run: npx playwright install --with-deps chromium
  or set FRAMEWRIGHT_BROWSER to the full path of a Chromium-based browser.`;

/**
 * The browser named by FRAMEWRIGHT_BROWSER, or else an installed Chromium, Chrome or Edge. Installs nothing.
 * @returns {string | undefined} the path of its program
 * @throws {Error} if FRAMEWRIGHT_BROWSER names something that does not run
 */
export function findInstalledBrowser() {
  const named = process.env.FRAMEWRIGHT_BROWSER;
  if (named) {
    if (runs(named)) return named;
    throw new Error(`FRAMEWRIGHT_BROWSER is ${named}, which is not a browser that runs.`);
  }
  return usualPlaces().find(runs);
}

/**
 * The browser for tests that need no window and no serial port: the same Chromium without its windows, which opens a page
 * for two thirds of the processor time, where it is installed and no other is named. Installs nothing.
 * @returns {string | undefined} the path of its program
 */
export function findBrowserWithoutWindows() {
  const path = process.env.FRAMEWRIGHT_BROWSER ? undefined : onPath('chromium-headless-shell');
  return path !== undefined && runs(path) ? path : findInstalledBrowser();
}

/**
 * Any browser for the tests: an installed one, Playwright's own, or one installed now.
 * @returns {Promise<string | undefined>} the path of its program
 */
export async function findOrInstallBrowser() {
  return findInstalledBrowser() ?? (await playwrightBrowser()) ?? (await downloadBrowser()) ?? (await aptBrowser());
}

async function playwrightBrowser() {
  const { chromium } = await import('@playwright/test');
  const path = chromium.executablePath();
  return path && runs(path) ? path : undefined;
}

async function downloadBrowser() {
  console.log('No browser found: asking Playwright to download Chromium …');
  const env = { PLAYWRIGHT_DOWNLOAD_CONNECTION_TIMEOUT: '10000' };
  await runNpm(['exec', '--', 'playwright', 'install', 'chromium'], { env, timeout: 180_000 });
  return playwrightBrowser();
}

/** Debian's packages, where this user may install packages without being asked for a password. */
async function aptBrowser() {
  // Not every distribution has the second.
  for (const name of ['chromium', 'chromium-headless-shell']) await installDebianPackages([name]);
  return findInstalledBrowser();
}

/** @returns {string[]} */
function usualPlaces() {
  if (process.platform === 'darwin') {
    const apps = ['Google Chrome', 'Chromium', 'Microsoft Edge'];
    return ['/Applications', join(process.env.HOME ?? '', 'Applications')].flatMap((folder) =>
      apps.map((app) => join(folder, `${app}.app`, 'Contents', 'MacOS', app)),
    );
  }
  if (process.platform === 'win32') {
    const { ProgramFiles, LOCALAPPDATA } = process.env;
    const folders = [ProgramFiles, process.env['ProgramFiles(x86)'], LOCALAPPDATA].filter((folder) => folder);
    const programs = ['Google/Chrome', 'Chromium', 'Microsoft/Edge'].map((app) =>
      join(app, 'Application', app === 'Microsoft/Edge' ? 'msedge.exe' : 'chrome.exe'),
    );
    return folders.flatMap((folder) => programs.map((program) => join(folder ?? '', program)));
  }
  return [...names.flatMap((name) => onPath(name) ?? []), '/opt/google/chrome/chrome', '/snap/bin/chromium'];
}

/**
 * Whether the program starts: some distributions put a stub there that only tells what to install, and a downloaded
 * browser may lack libraries. Windows has no such stubs, and there `--version` would open a window.
 * @param {string} path
 */
function runs(path) {
  if (!existsSync(path)) return false;
  if (process.platform === 'win32') return true;
  return spawnSync(path, ['--version'], { timeout: 20_000 }).status === 0;
}
