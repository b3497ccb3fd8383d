// `npm run mutate [layer or file …]`: small changes to the sources, one at a time, and how many of them the unit tests notice.
// Of each layer a sample, of the files below all of them. Not part of `npm test`: a layer takes many minutes.
import { existsSync } from 'node:fs';
import { join, relative } from 'node:path';
import { Stryker } from '@stryker-mutator/core';
import { root } from './run.mjs';

const SAMPLE = Number(process.env['MUTANTS'] ?? 300);
const TARGET = 80;

const sampled = ['modbus', 'notation', 'diagnosis', 'devices', 'workbench'];
const inFull = [
  'src/bus/guard.ts',
  'src/modbus/encode-frame.ts',
  'src/modbus/decode-frame.ts',
  'src/workbench/frame/link.ts',
];
const subjects = [
  ...inFull.map((path) => ({ name: path, mutate: path, layer: path.split('/')[1] ?? '', sample: undefined })),
  ...sampled.map((layer) => ({ name: layer, mutate: `src/${layer}/**/*.ts`, layer, sample: SAMPLE })),
];

const wanted = process.argv.slice(2);
const names = subjects.map(({ name }) => name);
const others = wanted.filter((name) => !names.includes(name));
if (others.length > 0) {
  console.error(`There is no ${others.join(', ')}. It can be: ${names.join(', ')}.`);
  process.exit(1);
}
const rows = [];
for (const subject of subjects) {
  if (wanted.length > 0 && !wanted.includes(subject.name)) continue;
  rows.push(await tryAll(subject));
}
console.log(`\n${'subject'.padEnd(32)}  mutants  tried  noticed  not reached  score`);
for (const { name, mutants, tried, noticed, unreached, score } of rows) {
  const numbers = [String(mutants).padStart(7), String(tried).padStart(6), String(noticed).padStart(8)];
  console.log(
    `${name.padEnd(32)}  ${numbers.join(' ')} ${String(unreached).padStart(12)} ${score.toFixed(1).padStart(6)} %`,
  );
}
const below = rows.filter(({ score }) => !(score >= TARGET));
if (below.length > 0) console.log(`\nBelow ${TARGET} %: ${below.map(({ name }) => name).join(', ')}.`);
process.exitCode = below.length === 0 && rows.length > 0 ? 0 : 1;

/**
 * The mutants of a subject. Those that no test reaches are known without a run, so that all of them count, and the sample is
 * taken of the others.
 * @param {{ name: string, mutate: string, layer: string, sample: number | undefined }} subject
 */
async function tryAll({ name, mutate, layer, sample }) {
  process.env['FRAMEWRIGHT_MUTANTS'] = String(sample ?? Number.MAX_SAFE_INTEGER);
  const own = `tests/unit/${layer}`;
  process.env['FRAMEWRIGHT_TESTS'] = existsSync(join(root, own)) ? own : 'tests/unit';
  const stryker = new Stryker({
    // The devices that come with the page are data.
    mutate: [mutate, '!src/devices/built-in/**'],
    testRunner: 'nearest-first',
    vitest: { configFile: 'vitest.quick.config.ts', related: false },
    plugins: ['@stryker-mutator/vitest-runner', './scripts/mutation-runner.mjs', './scripts/mutation-sample.mjs'],
    checkers: ['sample'],
    // Stryker would rewrite it by means of the compiler, whose version 7 has no such interface.
    tsconfigFile: 'no-tsconfig.json',
    coverageAnalysis: 'perTest',
    dryRunTimeoutMinutes: 30,
    // A loop without end is noticed by its count; a busy machine is no reason to call a mutant noticed.
    timeoutMS: 60_000,
    concurrency: Number(process.env['CONCURRENCY'] ?? 2),
    ignorePatterns: ['dist', '.cache', 'bench', 'docs', 'tests/browser', 'tests/serial'],
    tempDirName: '.cache/stryker',
    reporters: ['dots'],
    logLevel: /** @type {any} */ ('warn'),
    allowConsoleColors: false,
  });
  const results = await stryker.runMutationTest();
  /** @param {string[]} statuses */
  const all = (...statuses) => results.filter(({ status }) => statuses.includes(status));
  const noticed = all('Killed', 'Timeout', 'RuntimeError').length;
  const survived = all('Survived');
  const unreached = all('NoCoverage');
  console.log(`\n\n── ${name}: not noticed`);
  for (const { fileName, location, replacement, status } of [...survived, ...unreached]) {
    const { line, column } = location.start;
    const what = replacement.replaceAll(/\s+/g, ' ').slice(0, 100);
    console.log(
      `${relative(root, fileName)}:${line + 1}:${column + 1} ${status === 'NoCoverage' ? 'not reached' : ''} → ${what}`,
    );
  }
  const tried = noticed + survived.length;
  const reached = all('CompileError').length + tried;
  const mutants = reached + unreached.length;
  const score = (100 * (noticed / Math.max(1, tried)) * reached) / Math.max(1, mutants);
  return { name, mutants, tried, noticed, unreached: unreached.length, score };
}
