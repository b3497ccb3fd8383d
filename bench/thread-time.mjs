// The processor time of one thread of another process, sampled all the time: what a browser does not tell of its tasks.
import { once } from 'node:events';
import { readdirSync, readFileSync } from 'node:fs';
import { setTimeout as pause } from 'node:timers/promises';
import { Worker } from 'node:worker_threads';

/** Milliseconds from one sample to the next. */
const EACH = 2;
/** Milliseconds for which a page is kept busy, so that its process is known by it. */
const BUSY = 300;
/** The part of that in which its thread works at least, however busy the machine is. */
const SEEN = 0.1;

/** Samples in a thread of its own: what else the benchmark does holds it up no more than the machine does. */
const SAMPLER = `
const { closeSync, openSync, readSync } = require('node:fs');
const { parentPort, workerData: { pid, each } } = require('node:worker_threads');
const file = openSync('/proc/' + pid + '/schedstat', 'r');
const buffer = Buffer.alloc(128);
let samples = [];
const timer = setInterval(() => {
  const before = performance.timeOrigin + performance.now();
  const length = readSync(file, buffer, 0, buffer.length, 0);
  const after = performance.timeOrigin + performance.now();
  samples.push([before, after, Number(buffer.toString('latin1', 0, length).split(' ')[0]) / 1e6]);
}, each);
parentPort.on('message', (what) => {
  if (what === 'end') {
    clearInterval(timer);
    closeSync(file);
    return parentPort.close();
  }
  parentPort.postMessage(samples);
  samples = [];
});
`;

/**
 * Watches the main thread of the process in which a page is.
 * @param parent the process of the browser
 * @param evaluate runs a function in the page
 * @returns `undefined` where the system does not tell the time of threads
 */
export async function watchPage(parent, evaluate) {
  const before = new Map(mainThreads(parent));
  if (before.size === 0) return undefined;
  const keepBusy = () =>
    evaluate((busy) => {
      const from = performance.now();
      while (performance.now() < from + busy);
      return [performance.timeOrigin + from, performance.timeOrigin + performance.now()];
    }, BUSY);
  await keepBusy();
  await pause(EACH);
  const [[pid] = []] = mainThreads(parent)
    .map(([one, time]) => [one, time - (before.get(one) ?? time)])
    .sort(([, one], [, other]) => other - one);
  const sampler = new Worker(SAMPLER, { eval: true, workerData: { pid, each: EACH } });
  const taken = () =>
    new Promise((done) => {
      sampler.once('message', done);
      sampler.postMessage('take');
    });
  /**
   * The most processor time within one of these spans, in milliseconds, at most that much too high as the samples around it are apart.
   * Spans are pairs of milliseconds since 1970; forgets what was sampled before.
   */
  const most = async (spans) => {
    const samples = await taken();
    const within = ([from, to]) => {
      const first = samples.findLast(([, after]) => after <= from) ?? samples[0];
      const last = samples.find(([start]) => start >= to) ?? samples.at(-1);
      return last === undefined ? 0 : Math.min(to - from, last[2] - first[2]);
    };
    return Math.max(0, ...spans.map(within));
  };
  await taken();
  const seen = await most([await keepBusy()]);
  if (seen < SEEN * BUSY)
    throw new Error(`The page was busy for ${BUSY} ms, and its thread seems to have worked for ${seen} ms.`);
  return {
    most,
    /** To be called while the page is still there. */
    async end() {
      sampler.postMessage('end');
      await once(sampler, 'exit');
    },
  };
}

/** The processes that a process began and those that they began, each with the processor time of its main thread in milliseconds. */
function mainThreads(parent) {
  try {
    const parents = new Map();
    for (const name of readdirSync('/proc').filter((one) => /^\d+$/.test(one))) {
      try {
        const [, above] = readFileSync(`/proc/${name}/stat`, 'latin1').split(') ')[1].split(' ');
        parents.set(Number(name), Number(above));
      } catch {
        // It has ended meanwhile.
      }
    }
    const isOurs = (pid) => pid !== undefined && (pid === parent || isOurs(parents.get(pid)));
    return [...parents.keys()]
      .filter((pid) => pid !== parent && isOurs(pid))
      .map((pid) => [pid, Number(readFileSync(`/proc/${pid}/schedstat`, 'latin1').split(' ')[0]) / 1e6]);
  } catch {
    return [];
  }
}
