// What the tests of programs need besides Node: compilers and packages of other languages, with their versions in
// programs-tools.json. Vitest calls `setup` before the tests; it is quick when all is there.
import { existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { installDebianPackages, onPath } from './debian.mjs';
import { root, run } from './run.mjs';

const tools = JSON.parse(readFileSync(new URL('programs-tools.json', import.meta.url), 'utf8'));

/** Where the packages are, and the programs while they are tested. */
export const cache = join(root, '.cache', 'programs');

/** The Python that has the packages, and its commands such as mypy. */
const venv = join(cache, 'venv', 'bin');

/** @type {[command: string, packages: string[]][]} */
const commands = Object.entries(tools.commands);

/**
 * Packages of a language: what they are, the command without which they cannot be had, and how to get them.
 * @type {Record<string, { wanted: unknown, needs: string, install: () => Promise<boolean> }>}
 */
const packages = {
  python: {
    wanted: tools.python,
    needs: 'python3',
    install: async () => {
      const wanted = Object.entries(tools.python).map(([name, version]) => `${name}==${version}`);
      const make = async () => (await run('python3', ['-m', 'venv', '--clear', join(cache, 'venv')])) === 0;
      // Debian's Python comes without it.
      if (!(await make())) await installDebianPackages(['python3-venv']);
      return (
        (existsSync(join(venv, 'pip')) || (await make())) &&
        (await run(join(venv, 'pip'), ['install', '-q', '--disable-pip-version-check', ...wanted])) === 0
      );
    },
  },
};

/**
 * Installs what is missing, where this user may.
 * @returns {Promise<Record<string, string>>} what is still missing, by the name of the command or language, and how to get it
 */
export async function prepareProgramTools() {
  mkdirSync(cache, { recursive: true });
  const absent = () => commands.filter(([name]) => !onPath(name));
  if (absent().length > 0) await installDebianPackages([...new Set(absent().flatMap(([, names]) => names))]);
  /** @type {Record<string, string>} */
  const missing = {};
  for (const [name, names] of absent()) missing[name] = `no ${name} (apt-get install ${names.join(' ')})`;
  for (const [language, { wanted, needs, install }] of Object.entries(packages)) {
    if (missing[needs]) missing[language] = missing[needs];
    else if (!(await prepare(language, JSON.stringify(wanted), install))) {
      missing[language] = `packages for ${language} could not be installed: ${JSON.stringify(wanted)}`;
    }
  }
  return missing;
}

/**
 * Installs packages unless the same have been installed before.
 * @param {string} language
 * @param {string} wanted
 * @param {() => Promise<boolean>} install
 */
async function prepare(language, wanted, install) {
  const stamp = join(cache, `${language}.stamp`);
  if (existsSync(stamp) && readFileSync(stamp, 'utf8') === wanted) return true;
  console.log(`Installing packages for ${language} …`);
  if (!(await install())) return false;
  writeFileSync(stamp, wanted);
  return true;
}

/**
 * Vitest's global setup: tells the tests what is missing.
 * @param {{ provide: (key: 'missing', value: Record<string, string>) => void }} project
 */
export async function setup(project) {
  project.provide('missing', await prepareProgramTools());
}
