import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { run } from './run.mjs';

/**
 * The path of a program, if it is installed.
 * @param {string} name
 */
export function onPath(name) {
  return (process.env.PATH ?? '')
    .split(delimiter)
    .map((folder) => join(folder, name))
    .find((path) => existsSync(path));
}

/** @type {Promise<void>} */
let last = Promise.resolve();

/**
 * Installs Debian's packages where this user may do so without being asked for a password; elsewhere, and where it fails,
 * nothing happens, and what is missing is found missing later. Calls wait for each other, as apt-get lets only one in.
 * @param {readonly string[]} packages
 */
export function installDebianPackages(packages) {
  last = last.then(() => install(packages));
  return last;
}

/** @param {readonly string[]} packages */
async function install(packages) {
  if (process.platform !== 'linux' || !onPath('apt-get')) return;
  const sudo = process.getuid?.() === 0 ? [] : ['sudo', '-n'];
  if (sudo.length > 0 && spawnSync('sudo', ['-n', 'true']).status !== 0) return;
  console.log(`Installing ${packages.join(', ')} with apt-get …`);
  const apt = async (/** @type {string[]} */ ...args) => {
    const [command = '', ...rest] = [...sudo, 'apt-get', '-o', 'DPkg::Lock::Timeout=120', ...args];
    await run(command, rest, { env: { DEBIAN_FRONTEND: 'noninteractive' }, timeout: 300_000 });
  };
  await apt('update', '-qq');
  await apt('install', '-y', '-qq', '--no-install-recommends', ...packages);
}
