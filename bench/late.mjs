// `npm run bench:late`: what is shown as good on lines whose devices are late, repeat themselves, refuse before they answer, or
// do nothing wrong, on a virtual clock. `--seed 7` plays one seed, `--seeds 20` so many; a number is that of the transactions.
import { parseArgs } from 'node:util';
import { createServer } from 'vite';

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: { seed: { type: 'string' }, seeds: { type: 'string', default: '5' } },
});
const SEEDS =
  values.seed === undefined ? Array.from({ length: Number(values.seeds) }, (_, at) => at + 1) : [Number(values.seed)];
const EACH = Math.ceil(Number(positionals[0] ?? 5000) / SEEDS.length);
const TRANSACTIONS = EACH * SEEDS.length;
const TIMEOUT = 200;

const server = await createServer({
  server: { middlewareMode: true, hmr: false, ws: false },
  appType: 'custom',
  logLevel: 'error',
  optimizeDeps: { noDiscovery: true },
});
const { kinds, missed, tallyOf } = await server.ssrLoadModule('/tests/unit/bus/late-line.ts');

const columns = (...cells) =>
  console.log(cells.map((cell, i) => String(cell)[i === 0 ? 'padEnd' : 'padStart'](i === 0 ? 30 : 10)).join(''));
const percent = (part, all) => (all === 0 ? '–' : `${((100 * part) / all).toFixed(1)} %`);
const mean = (sum, count) => (count === 0 ? '0' : (sum / count).toFixed(0));

console.log(
  `\n${TRANSACTIONS} transactions each, time-out ${TIMEOUT} ms, no silence between frames, seeds ${SEEDS.join(', ')}.`,
);
console.log(
  'Good, doubtful and bad are of the replies that came within the time-out; ms: how long they were held back.',
);
/** All of them together: `run` is the longest, the rest is added up. */
const sumOf = (tallies) =>
  tallies.reduce((sum, tally) =>
    Object.fromEntries(
      Object.entries(tally).map(([key, value]) => [key, key === 'run' ? Math.max(sum[key], value) : sum[key] + value]),
    ),
  );
let failures = 0;
for (const quiet of [true, false]) {
  for (const retries of [0, 2]) {
    for (const interval of [0, 1000]) {
      const way = quiet ? 'quiet after a time-out' : 'not quiet after a time-out';
      console.log(`\nInterval ${interval} ms, retries ${retries}, ${way}`);
      columns('', 'wrong', 'good', 'doubtful', 'bad', 'run', 'held', 'ms', 'ms each');
      for (const kind of kinds) {
        const helds = kind.target === 'clean' ? ['changing', 'constant', 'equal'] : ['changing'];
        for (const held of helds) {
          const one = { ...kind, held, interval, rules: { timeout: TIMEOUT, retries, quiet } };
          const tallies = [];
          for (const seed of SEEDS) tallies.push(await tallyOf(one, EACH, seed));
          const tally = sumOf(tallies);
          const { wrong, answered, answeredGood, answeredDoubtful, answeredBad, run, delay, delayed } = tally;
          columns(
            kind.target === 'clean' ? `${kind.name}, ${held}` : kind.name,
            wrong,
            percent(answeredGood, answered),
            answeredDoubtful,
            answeredBad,
            run,
            delayed,
            mean(delay, delayed),
            mean(tally.time, tally.transactions),
          );
          const faults = quiet ? missed(kind, tally) : [];
          if (faults.length > 0) console.log(`  NOT MET: ${faults.join('; ')}`);
          failures += faults.length;
        }
      }
    }
  }
}
console.log(
  `\nTargets, with the quiet time: nothing wrong is good; where nothing is wrong, nothing is doubtful or held back;`,
);
console.log(`where a device is right most times, 90 % are good: ${failures === 0 ? 'met' : 'NOT ALL MET'}`);
console.log('Where replies come in any order, more than the quiet time late: at most two in a thousand are wrong.');
process.exitCode = failures === 0 ? 0 : 1;
await server.close();
