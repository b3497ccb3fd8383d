// `npm run bench:memory`: whether what the page holds stays the same while it polls: 17 minutes at full speed in the built page, and
// a day on a clock that does not wait. `MINUTES` and `HOURS` say otherwise.
import { setFlagsFromString } from 'node:v8';
import { runInNewContext } from 'node:vm';
import { createServer } from 'vite';
import { minutesOfPolling } from './memory/page.mjs';

const MINUTES = Number(process.env.MINUTES ?? 17);
const HOURS = Number(process.env.HOURS ?? 24);
/** Rounds after which the log of the bus has come to its limit; the trace that shows it grows to twice as much and is cut again. */
const FULL = 65_000;
/** What is called flat: the second half of the time comes to so much more than the first at most. */
const MOST = 0.05;

/**
 * Prints a line for each time that it is called, and says at the end whether what is held is flat.
 * @param {string} title
 * @param {readonly string[]} heads
 */
function table(title, heads) {
  const lines = [];
  const print = (cells) => console.log(cells.map((cell) => String(cell).padStart(9)).join(''));
  console.log(`\n${title}, MB held after a collection`);
  print(heads);
  return {
    line(time, rounds, bytes) {
      print([time, rounds, ...bytes.map((one) => (one / 1e6).toFixed(1))]);
      lines.push({ rounds, held: bytes.reduce((sum, one) => sum + one, 0) });
    },
    isFlat() {
      const half = Math.ceil(lines.length / 2);
      const [first, second] = [lines.slice(0, half), lines.slice(half)].map((some) =>
        Math.max(...some.map(({ held }) => held)),
      );
      const added = second / first - 1;
      const isFull = lines[half - 1].rounds >= FULL;
      const verdict = !isFull
        ? `NOT JUDGED before ${FULL} rounds: give it more time`
        : added <= MOST
          ? 'flat'
          : 'NOT FLAT';
      console.log(
        `The most in the second half is ${(100 * added).toFixed(1)} % above the most in the first: ${verdict}`,
      );
      return isFull && added <= MOST;
    },
  };
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
  const { line, isFlat } = table(`${HOURS} hours, a round each ${INTERVAL} ms`, ['hour', 'rounds', 'process']);
  await dayOfPolling(HOURS, (hour, rounds) => {
    gc();
    const { heapUsed, arrayBuffers } = process.memoryUsage();
    line(hour, rounds, [heapUsed + arrayBuffers]);
  });
  await server.close();
  return isFlat();
}

async function minutes() {
  const heads = ['minute', 'rounds', 'window', 'session', 'trace'];
  const { line, isFlat } = table(`${MINUTES} minutes at full speed on the virtual bus`, heads);
  await minutesOfPolling(MINUTES, line);
  return isFlat();
}

const results = [HOURS > 0 ? await day() : true, MINUTES > 0 ? await minutes() : true];
process.exit(results.every(Boolean) ? 0 : 1);
