import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { root } from './run.mjs';

/** The packages whose code is in the page. The build compares them with what it has put in. */
export const packagesInPage = [
  '@preact/signals',
  '@preact/signals-core',
  'fflate',
  'highlight.js',
  'highlightjs-structured-text',
  'idb-keyval',
  'preact',
  'uplot',
  'yaml',
];

const id = 'virtual:licences';

/** @typedef {{ name: string, version: string, licence: string, text: string }} Licence */

/**
 * A package with its licence's name and text.
 * @param {string} name
 * @returns {Licence}
 */
export function licenceOf(name) {
  const folder = join(root, 'node_modules', name);
  const { version, license } = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  const file = readdirSync(folder).find((each) => /^licen[cs]e/i.test(each));
  if (file === undefined) throw new Error(`${name} has no text of its licence.`);
  return { name, version, licence: license, text: readFileSync(join(folder, file), 'utf8').trim() };
}

/** Ours, and those of the packages in the page. */
function all() {
  const { name, version, license } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  /** @type {Licence} */
  const ours = { name, version, licence: license, text: readFileSync(join(root, 'LICENSE'), 'utf8').trim() };
  return { ours, others: packagesInPage.map(licenceOf) };
}

/**
 * The licences for the page, as the module `virtual:licences`, and beside it, as `licences.txt`.
 * @returns {import('vite').Plugin}
 */
export function licences() {
  return {
    name: 'licences',
    resolveId: (source) => (source === id ? `\0${id}` : undefined),
    load: (source) => (source === `\0${id}` ? `export const { ours, others } = ${JSON.stringify(all())};` : undefined),
    generateBundle(_, bundle) {
      const chunks = Object.values(bundle).filter((part) => part.type === 'chunk');
      const found = chunks.flatMap(({ moduleIds }) => moduleIds.flatMap((module) => packageOf(module) ?? []));
      const more = [...new Set(found)].filter((name) => !packagesInPage.includes(name));
      if (more.length > 0) this.error(`In the page, but not in packagesInPage: ${more.join(', ')}.`);
      /** @param {Licence} of */
      const text = ({ name, version, licence, text }) => `${name} ${version}, ${licence}\n\n${text}\n`;
      const { ours, others } = all();
      this.emitFile({
        type: 'asset',
        fileName: 'licences.txt',
        source: [ours, ...others].map(text).join(`\n${'─'.repeat(72)}\n\n`),
      });
    },
  };
}

/** @param {string} module */
const packageOf = (module) =>
  /.*[\\/]node_modules[\\/]((?:@[^\\/]+[\\/])?[^\\/]+)/.exec(module)?.[1]?.replace('\\', '/');
