// `npm run release:check`: whether what is here can be published under its version. Builds the page and the library, and writes
// `dist/sbom.cdx.json`, what the page and the package are made of (CycloneDX).
import { spawnSync } from 'node:child_process';
import { readFileSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { onPath } from './debian.mjs';
import { licenceOf, packagesInPage } from './licences.mjs';
import { checkPackage } from './package-check.mjs';
import { root, runScript } from './run.mjs';

/** Licences under which a package may be in the page or in the package of the library, by their names in SPDX. */
const allowed = ['MIT', 'ISC', 'BSD-2-Clause', 'BSD-3-Clause', '0BSD', 'Apache-2.0'];

/** What checks the workflows, and at which version it is fetched where Go is there and it is not. */
const actionlint = 'github.com/rhysd/actionlint/cmd/actionlint@v1.7.7';

const { version, dependencies } = JSON.parse(read('package.json'));
const packages = [...new Set([...packagesInPage, ...Object.keys(dependencies)])].sort();

/** @type {readonly { what: string, fault: () => string | undefined | Promise<string | undefined> }[]} */
const checks = [
  { what: 'everything is committed', fault: () => output('git', ['status', '--porcelain']) },
  { what: 'the version is the changelog’s newest, with its day', fault: changelog },
  { what: 'the lock file has the version', fault: lock },
  { what: 'the page is built', fault: () => built('build') },
  { what: 'the library is built', fault: () => built('build:lib') },
  { what: 'the package is whole, and can be used', fault: packed },
  { what: 'licences allow it', fault: licences },
  { what: 'dist/sbom.cdx.json says what it is made of', fault: bill },
  { what: 'workflows are sound', fault: workflows },
];

let failed = 0;
for (const { what, fault } of checks) {
  const found = (await fault())?.trim();
  if (found) failed++;
  console.log(`${found ? 'FAILED' : 'ok    '}  ${what}${found ? `\n${found.replace(/^/gm, '        ')}` : ''}`);
}
console.log(`\n${checks.length - failed} passed, ${failed} failed`);
process.exitCode = failed === 0 ? 0 : 1;

/** @param {string} file */
function read(file) {
  return readFileSync(join(root, file), 'utf8');
}

/**
 * What a program says; its complaint, if it fails.
 * @param {string} command
 * @param {string[]} args
 */
function output(command, args) {
  const { status, stdout, stderr, error } = spawnSync(command, args, { cwd: root, encoding: 'utf8' });
  return status === 0 ? stdout : `${stdout ?? ''}${stderr ?? error?.message}` || `${command} failed.`;
}

function changelog() {
  const newest = /^## (.+)$/m.exec(read('CHANGELOG.md'))?.[1] ?? '';
  const [, of, day] = /^(\d+\.\d+\.\d+) – (\d{4}-\d\d-\d\d)$/.exec(newest) ?? [];
  if (of === undefined) return `The newest heading is “${newest}”; “${version} – ” and the day are expected.`;
  if (of !== version) return `The package is ${version}, the newest heading is of ${of}.`;
  return Number.isNaN(Date.parse(day ?? '')) ? `${day} is not a day.` : undefined;
}

function lock() {
  const { version: locked, packages: all } = JSON.parse(read('package-lock.json'));
  return locked === version && all[''].version === version ? undefined : `It has ${locked}: run npm install.`;
}

/** @param {string} script */
async function built(script) {
  let said = '';
  const code = await runScript(script, [], {
    tell: (text) => {
      said += text;
    },
  });
  return code === 0 ? undefined : said;
}

async function packed() {
  let said = '';
  const outcome = await checkPackage((text) => {
    said += text;
  });
  return outcome.failed === 0 ? undefined : said;
}

function licences() {
  const others = packages.map(licenceOf).filter(({ licence }) => !allowed.includes(licence));
  return others.length === 0 ? undefined : others.map((each) => `${each.name} is under ${each.licence}`).join('\n');
}

/**
 * What is used of CycloneDX.
 * @typedef {{ 'bom-ref': string, name: string, properties?: unknown }} Component
 * @typedef {{ metadata: { component: Component }, components: Component[], dependencies: { ref: string, dependsOn: string[] }[] }} Bill
 */

/** npm names everything that is installed; the page and the package contain a part of it. */
function bill() {
  const said = spawnSync('npm', ['sbom', '--sbom-format', 'cyclonedx', '--package-lock-only', '--include=dev'], {
    cwd: root,
    encoding: 'utf8',
    shell: process.platform === 'win32',
    maxBuffer: 2 ** 26,
  });
  if (said.status !== 0) return said.stderr;
  /** @type {Bill} */
  const all = JSON.parse(said.stdout);
  const components = all.components
    .filter((each) => packages.includes(each.name))
    // npm calls what only the page has a tool of development.
    .map(({ properties, ...each }) => ({ ...each, scope: 'required' }));
  const refs = new Set([all.metadata.component['bom-ref'], ...components.map((each) => each['bom-ref'])]);
  const inside = all.dependencies
    .filter(({ ref }) => refs.has(ref))
    .map(({ ref, dependsOn }) => ({ ref, dependsOn: dependsOn.filter((each) => refs.has(each)) }));
  const written = { ...all, components, dependencies: inside };
  writeFileSync(join(root, 'dist', 'sbom.cdx.json'), `${JSON.stringify(written, undefined, 2)}\n`);
  const missing = packages.filter((each) => !components.some((component) => component.name === each));
  return missing.length === 0 ? undefined : `It lacks ${missing.join(', ')}.`;
}

function workflows() {
  if (onPath('actionlint')) return output('actionlint', []);
  if (onPath('go')) return output('go', ['run', actionlint]);
  const onServer = !['', '0', 'false'].includes(process.env.CI ?? '');
  console.log(
    `WORKFLOWS NOT CHECKED: neither actionlint nor go is installed (https://${actionlint.replace(/\/cmd.*/, '')}).`,
  );
  return onServer ? 'not checked' : undefined;
}
