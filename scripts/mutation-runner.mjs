// For Stryker: a mutant meets the tests that stand where its file stands first, and the others only where those notice
// nothing. Stryker by itself runs every test for each mutant in what a module works out when it is loaded.
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import { declareFactoryPlugin, PluginKind } from '@stryker-mutator/api/plugin';
import { DryRunStatus, MutantRunStatus } from '@stryker-mutator/api/test-runner';
import { strykerPlugins as vitestPlugins } from '@stryker-mutator/vitest-runner';

/** @typedef {import('@stryker-mutator/api/test-runner').TestRunner} TestRunner */
/** @typedef {import('@stryker-mutator/api/test-runner').MutantRunOptions} MutantRunOptions */

/** Where the processes of a run, which have this folder to themselves, keep the mutants that run in both ways. */
const BOTH = 'mutants-in-both.json';

/** The folder of tests that is nearest to a source: `tests/unit/bus` for `src/bus/jobs/poll.ts`. @param {string} source */
function folderOfTests(source) {
  const folder = dirname(source.replaceAll('\\', '/').replace(/^.*?\/src\//, ''));
  for (let at = folder; at !== '.'; at = dirname(at)) {
    if (existsSync(join('tests/unit', at))) return `tests/unit/${at}/`;
  }
  return undefined;
}

/** @implements {TestRunner} */
class NearestFirst {
  /** @param {TestRunner} runner */
  constructor(runner) {
    this.runner = runner;
    /** @type {Set<string> | undefined} */
    this.both = undefined;
  }
  capabilities = () => this.runner.capabilities();
  init = async () => await this.runner.init?.();
  dispose = async () => await this.runner.dispose?.();

  /**
   * Stryker runs all tests for what runs both when modules are loaded and in some tests; here these tests are the first.
   * @type {TestRunner['dryRun']}
   */
  async dryRun(options) {
    const result = await this.runner.dryRun(options);
    if (result.status !== DryRunStatus.Complete || !result.mutantCoverage) return result;
    const { perTest, static: loaded } = result.mutantCoverage;
    const inTests = new Set(Object.values(perTest).flatMap((hits) => Object.keys(hits)));
    const both = Object.keys(loaded).filter((id) => inTests.has(id));
    for (const id of both) delete loaded[id];
    writeFileSync(BOTH, JSON.stringify(both));
    return result;
  }

  /** @param {MutantRunOptions} options */
  async mutantRun(options) {
    // Each run loads all modules anew, so that the mutant may as well be there from the beginning.
    const all = /** @type {MutantRunOptions} */ ({ ...options, mutantActivation: 'static' });
    this.both ??= new Set(/** @type {string[]} */ (JSON.parse(readFileSync(BOTH, 'utf8'))));
    if (this.both.has(options.activeMutant.id)) {
      const result = await this.runner.mutantRun(all);
      if (result.status !== MutantRunStatus.Survived) return result;
      delete all.testFilter;
    }
    const folder = folderOfTests(options.sandboxFileName);
    if (folder === undefined) return this.runner.mutantRun(all);
    // A test is named by its file, `#` and its own name, of which a part is enough.
    const near = all.testFilter?.filter((id) => id.includes(folder)) ?? [`${folder}#`];
    if (near.length === 0 || near.length === all.testFilter?.length) return this.runner.mutantRun(all);
    const result = await this.runner.mutantRun({ ...all, testFilter: near });
    return result.status === MutantRunStatus.Survived ? this.runner.mutantRun(all) : result;
  }
}

const [vitest] = vitestPlugins;
/** @param {any} injector */
const nearestFirst = (injector) => new NearestFirst(/** @type {any} */ (vitest).factory(injector));
nearestFirst.inject = [/** @type {const} */ ('$injector')];

export const strykerPlugins = [declareFactoryPlugin(PluginKind.TestRunner, 'nearest-first', nearestFirst)];
