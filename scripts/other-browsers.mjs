// Firefox and WebKitGTK, in which the page is tried besides Chromium.
import { existsSync, readdirSync } from 'node:fs';
import { join } from 'node:path';
import { installDebianPackages, onPath } from './debian.mjs';

const packages = ['firefox-esr', 'webkit2gtk-driver', 'xvfb'];

/** What is said where they are missing. */
export const howToGetTheOthers = `Firefox and WebKitGTK come from Debian or Ubuntu: apt-get install ${packages.join(' ')}
  (elsewhere FRAMEWRIGHT_FIREFOX is the path of a Firefox; WebKitGTK runs on Linux only).`;

/**
 * Finds the browsers, installed now where that may be done.
 * @returns {Promise<{ env: Record<string, string>, missing: string[] }>} the variables that `tests/browsers` reads, and the
 *   names of those that are not there
 */
export async function prepareOtherBrowsers() {
  if (firefox() === undefined || webkit() === undefined) await installDebianPackages(packages);
  const [fox, kit] = [firefox(), webkit()];
  return {
    env: { ...(fox && { FRAMEWRIGHT_FIREFOX: fox }), ...(kit && { FRAMEWRIGHT_WEBKIT: kit }) },
    missing: [...(fox ? [] : ['Firefox']), ...(kit ? [] : ['WebKitGTK'])],
  };
}

function firefox() {
  const { FRAMEWRIGHT_FIREFOX: named } = process.env;
  const usual = ['/Applications/Firefox.app/Contents/MacOS/firefox', 'C:\\Program Files\\Mozilla Firefox\\firefox.exe'];
  return named || onPath('firefox-esr') || onPath('firefox') || usual.find((path) => existsSync(path));
}

/** The program that drives it and the one that shows a window, with a colon between. */
function webkit() {
  if (process.platform !== 'linux' || !onPath('Xvfb')) return undefined;
  const driver = onPath('WebKitWebDriver');
  const folders = ['/usr/lib', '/usr/libexec', ...below('/usr/lib')].flatMap((folder) => [folder, ...below(folder)]);
  const window = folders
    .filter((folder) => /webkit2?gtk/.test(folder))
    .map((folder) => join(folder, 'MiniBrowser'))
    .find((path) => existsSync(path));
  return driver && window && `${driver}:${window}`;
}

/** @param {string} folder */
function below(folder) {
  if (!existsSync(folder)) return [];
  return readdirSync(folder, { withFileTypes: true })
    .filter((entry) => entry.isDirectory())
    .map(({ name }) => join(folder, name));
}
