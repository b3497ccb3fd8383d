// `npm run bench:memory`: whether what the page holds stays the same while it polls: ten minutes at full speed in the built page, and
// a day on a clock that does not wait. `MINUTES` and `HOURS` do less.
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { createServer } from 'vite';
import { printTable } from './built-page.mjs';
import { minutesOfPolling } from './memory/page.mjs';

const MINUTES = Number(process.env.MINUTES ?? 10);
const HOURS = Number(process.env.HOURS ?? 24);
/** What is called flat: the second half of the time adds at most so much to what is held at its beginning. */
const MOST = 0.05;

const mega = (bytes) => (bytes / 1e6).toFixed(1);

/**
 * Prints a table, and says whether it is flat.
 * @param {string} title
 * @param {readonly string[]} heads
 * @param {readonly { cells: readonly (string | number)[], bytes: readonly number[] }[]} lines
 */
function printLines(title, heads, lines) {
  console.log(`\n${title}`);
  printTable([heads, ...lines.map(({ cells, bytes }) => [...cells, ...bytes.map(mega)])]);
  const half = lines[Math.floor((lines.length - 1) / 2)];
  const sum = ({ bytes }) => bytes.reduce((all, one) => all + one, 0);
  const added = sum(lines.at(-1)) / sum(half) - 1;
  console.log(`The second half adds ${(100 * added).toFixed(1)} %: ${added <= MOST ? 'flat' : 'NOT FLAT'}`);
  return added <= MOST;
}

async function day() {
  const server = await createServer({
    server: { middlewareMode: true, hmr: false, ws: false, watch: null },
    appType: 'custom',
    logLevel: 'error',
    optimizeDeps: { noDiscovery: true },
  });
  const { dayOfPolling, INTERVAL } = await server.ssrLoadModule('/bench/memory/day.mjs');
  setFlagsFromString('--expose-gc');
  const gc = runInNewContext('gc');
  const lines = [];
  await dayOfPolling(HOURS, (hour, rounds, records) => {
    gc();
    const { heapUsed, arrayBuffers } = process.memoryUsage();
    lines.push({ cells: [hour, rounds, records], bytes: [heapUsed + arrayBuffers] });
  });
  await server.close();
  const title = `${HOURS} hours on a clock that does not wait, a round each ${INTERVAL} ms`;
  return printLines(title, ['hour', 'rounds', 'records kept', 'MB'], lines);
}

const results = [];
if (HOURS > 0) results.push(await day());
if (MINUTES > 0) {
  const lines = await minutesOfPolling(MINUTES);
  const title = `${MINUTES} minutes at full speed on the virtual bus, MB held after a collection`;
  results.push(printLines(title, ['minute', 'rounds', 'window', 'session', 'trace'], lines));
}
process.exit(results.every(Boolean) ? 0 : 1);
