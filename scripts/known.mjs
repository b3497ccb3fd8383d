// What the tests in browsers know of the source, built as one file: Playwright would read and translate each of 400 files of the
// source by itself, in each of its processes.
import { mkdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { build } from 'vite';
import { root } from './run.mjs';

const { '#known': known } = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8')).imports;

/**
 * Builds the file.
 * @returns what Node must have in its environment to find it under `#known`, which is the source itself otherwise
 */
export async function buildKnown() {
  const built = await build({
    configFile: false,
    publicDir: false,
    logLevel: 'error',
    build: {
      write: false,
      minify: false,
      target: 'node20',
      lib: { entry: known.default, formats: ['es'] },
      rolldownOptions: { output: { codeSplitting: false } },
    },
  });
  const [{ output }] = /** @type {[import('vite').Rolldown.RolldownOutput]} */ (built);
  const path = join(root, known['built-known']);
  mkdirSync(dirname(path), { recursive: true });
  // All at once: other tests may be reading it.
  writeFileSync(`${path}.${process.pid}`, output[0].code);
  renameSync(`${path}.${process.pid}`, path);
  return { NODE_OPTIONS: `${process.env.NODE_OPTIONS ?? ''} --conditions=built-known`.trim() };
}
