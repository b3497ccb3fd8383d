// For Stryker: of all mutants that tests reach only a sample is tried, the same in every run with the same seed. Stryker has no
// sampling of its own, but leaves out what a "checker" refuses.
import { createHash } from 'node:crypto';
import { CheckStatus } from '@stryker-mutator/api/check';
import { declareClassPlugin, PluginKind } from '@stryker-mutator/api/plugin';

const size = Number(process.env['FRAMEWRIGHT_MUTANTS'] ?? 300);
const seed = process.env['FRAMEWRIGHT_SEED'] ?? '1';

/** @typedef {import('@stryker-mutator/api/core').Mutant} Mutant */

/** @param {Mutant} mutant */
const rank = ({ fileName, location, mutatorName, replacement }) => {
  const place = fileName.replaceAll('\\', '/').replace(/^.*?\/(?=src\/)/, '');
  const what = JSON.stringify([seed, place, location, mutatorName, replacement]);
  return createHash('sha256').update(what).digest('hex');
};

class Sample {
  /** @type {Set<string>} */
  #tried = new Set();

  async init() {}

  /**
   * All mutants come in one call, and are answered as one group.
   * @param {Mutant[]} mutants
   */
  async group(mutants) {
    const ranked = mutants.map((mutant) => ({ id: mutant.id, rank: rank(mutant) }));
    ranked.sort((a, b) => (a.rank < b.rank ? -1 : 1));
    this.#tried = new Set(ranked.slice(0, size).map(({ id }) => id));
    return [mutants.map(({ id }) => id)];
  }

  /** @param {Mutant[]} mutants */
  async check(mutants) {
    const passed = /** @type {const} */ ({ status: CheckStatus.Passed });
    const left = /** @type {const} */ ({ status: CheckStatus.CompileError, reason: 'not in the sample' });
    return Object.fromEntries(mutants.map(({ id }) => [id, this.#tried.has(id) ? passed : left]));
  }
}

export const strykerPlugins = [declareClassPlugin(PluginKind.Checker, 'sample', Sample)];
