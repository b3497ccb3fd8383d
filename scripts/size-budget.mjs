import { readFileSync } from 'node:fs';
import { join, posix } from 'node:path';
import { gzipSync } from 'node:zlib';
import { parseAst } from 'vite';
import { root } from './run.mjs';

/** Bytes of JavaScript and CSS, gzipped, that the page may load before it can be used. */
const budget = 35_000;

/**
 * Weighs what the built page loads at first: the scripts and styles in its HTML, and what those scripts import.
 * Tells a row a file.
 * @param {(text: string) => void} tell
 * @param {string} [folder] where the built page is
 * @returns {boolean} whether it keeps to the budget
 */
export function sizeFits(tell, folder = join(root, 'dist')) {
  const files = firstLoad(folder);
  const sizes = files.map((file) => gzipSync(readFileSync(join(folder, file)), { level: 9 }).length);
  const total = sizes.reduce((sum, size) => sum + size, 0);
  files.forEach((file, index) => {
    tell(`  ${kilobytes(sizes[index] ?? 0)}  ${file}\n`);
  });
  const fits = total <= budget;
  tell(
    `  ${kilobytes(total)}  first load, gzipped, of at most ${kilobytes(budget).trim()}${fits ? '' : ': TOO BIG'}\n`,
  );
  return fits;
}

/** @param {string} folder */
function firstLoad(folder) {
  const html = readFileSync(join(folder, 'index.html'), 'utf8');
  const named = [...html.matchAll(/<(script|link)\b[^>]*>/g)].flatMap(([tag]) => linkedFile(tag) ?? []);
  const files = new Set(named.map((name) => local(name, '.')));
  for (const file of files) {
    if (!file.endsWith('.js')) continue;
    for (const specifier of staticImports(readFileSync(join(folder, file), 'utf8'))) {
      files.add(local(specifier, posix.dirname(file)));
    }
  }
  if (![...files].some((file) => file.endsWith('.js'))) throw new Error('The built page loads no script at all.');
  return [...files];
}

/**
 * The file that a tag makes the browser fetch at once, if it is a script or a style.
 * @param {string} tag
 */
function linkedFile(tag) {
  if (tag.startsWith('<script')) return attribute(tag, 'src');
  return /^(stylesheet|modulepreload)$/.test(attribute(tag, 'rel') ?? '') ? attribute(tag, 'href') : undefined;
}

/**
 * @param {string} tag
 * @param {string} name
 */
function attribute(tag, name) {
  return new RegExp(`\\b${name}\\s*=\\s*["']?([^"'\\s>]+)`).exec(tag)?.[1];
}

/**
 * @param {string} name as written in a file
 * @param {string} from the folder of that file
 */
function local(name, from) {
  if (!name.startsWith('.')) throw new Error(`The page loads ${name}, which is no file of its own.`);
  return posix.join(from, name);
}

/** @param {string} code */
function staticImports(code) {
  return parseAst(code).body.flatMap((node) => ('source' in node && node.source ? [node.source.value] : []));
}

/** @param {number} bytes */
function kilobytes(bytes) {
  return `${(bytes / 1000).toFixed(2).padStart(6)} kB`;
}
