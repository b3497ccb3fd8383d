// `npm run bench:diagnose`: of random frames damaged in each named way, in how many the right finding comes first; without
// and with the request that was answered, of the same frames in every run. `npm test` does the same with few frames and
// `--check`: then a way that is below 95 % by more than chance explains, and a finding without a way, is an error.
import { runScript } from '../scripts/run.mjs';
import { Random } from './random.mjs';

const CASES = Number(process.env.CASES ?? 500);
const TARGET = 95;
const CHECK = '--check';
/** By how much a share of so few cases falls below its percentage by chance: two standard deviations. */
const MARGIN = 2 * Math.sqrt((TARGET * (100 - TARGET)) / CASES);

if (process.env.BUILT === undefined && (await runScript('build:lib')) !== 0) process.exit(1);
const { diagnose, findingKinds } = await import('../dist/lib/framewright.js');
const { conversation } = await import('./diagnose/conversations.mjs');
const { caseOf, ways, withoutWay } = await import('./diagnose/ways.mjs');

const wanted = process.argv.slice(2).filter((argument) => argument !== CHECK);
let below = 0;
const fallen = [];
console.log(`${'damage'.padEnd(30)} ${'finding'.padEnd(30)}  alone  with request  confident but wrong`);
for (const way of ways.filter(({ name }) => wanted.length === 0 || wanted.some((part) => name.includes(part)))) {
  const expected = [way.finding].flat();
  const alone = way.needs === 'reply' || way.needs === 'distinct' ? undefined : share(way, expected, false);
  const known = way.needs === 'none' || way.only === 'coil request' ? undefined : share(way, expected, true);
  const mistaken = (alone?.mistaken ?? 0) + (known?.mistaken ?? 0);
  const shown = [alone, known].map((one) => (one === undefined ? '–' : `${one.right.toFixed(1)} %`));
  const shares = [alone, known].flatMap((one) => one?.right ?? []);
  if (shares.some((right) => right < TARGET)) below++;
  if (shares.some((right) => right < TARGET - MARGIN)) fallen.push(way.name);
  console.log(
    `${way.name.padEnd(30)} ${expected.join(', ').padEnd(30)} ${shown[0].padStart(7)} ${shown[1].padStart(12)} ${mistaken.toFixed(1).padStart(14)} %`,
  );
  for (const result of [alone, known]) if (result && process.env.SHOW) console.log(result.missed);
}
console.log(below === 0 ? `\nAll at ${TARGET} % or above.` : `\n${below} below ${TARGET} %.`);

const made = new Set([...ways.flatMap(({ finding }) => finding), ...withoutWay]);
const wayless = Object.keys(findingKinds).filter((code) => !made.has(code));

if (process.argv.includes(CHECK)) {
  if (fallen.length > 0) console.log(`\nFar below ${TARGET} %: ${fallen.join(', ')}.`);
  if (wayless.length > 0) console.log(`\nNo way of damage makes: ${wayless.join(', ')}.`);
  if (fallen.length > 0 || wayless.length > 0) process.exitCode = 1;
}

/** How many of the cases are found first, and in how many something else is claimed with confidence. */
function share(way, expected, known) {
  const random = new Random();
  const missed = new Map();
  let right = 0;
  let mistaken = 0;
  for (let n = 0; n < CASES; ) {
    const damaged = caseOf(way, conversation(random), random, known);
    if (damaged === undefined) continue;
    n++;
    const [first] = diagnose(damaged.bytes, damaged.context);
    if (expected.includes(first?.code)) right++;
    else {
      if (first?.confidence !== 'possible') mistaken++;
      const code = `${first?.code} (${first?.confidence})`;
      missed.set(
        code,
        [...(missed.get(code) ?? []), Buffer.from(damaged.bytes).toString('hex').slice(0, 80)].slice(0, 3),
      );
    }
  }
  return { right: (100 * right) / CASES, mistaken: (100 * mistaken) / CASES, missed };
}
