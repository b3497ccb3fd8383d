// One program at one subject, in a process of its own, led by run.mjs:
// 'warm up' is answered when the compiler has settled, 'sample' with how many inputs were done a second.
import { checkAll } from './answers.mjs';
import { loadPeer } from './peers.mjs';
import { subjects } from './subjects.mjs';

const WARM_UP_MS = 200;
const SAMPLE_MS = 25;

const [program, id] = process.argv.slice(2);
const subject = subjects.find((candidate) => candidate.id === id);
const peer = await loadPeer(program);
const measured = peer[subject.measure];
const { run, prepare = (input) => input } = measured;

const cases = subject.cases();
const inputs = cases.map(({ input }) => prepare(input));
// Every answer is kept for a while, so that none can be optimised away.
const answers = inputs.map((input) => run(input));
checkAll(subject, measured, cases, answers);

let rounds = 1;

const does = {
  'warm up': warmUp,
  sample: () => (rounds * inputs.length * 1000) / timed(),
  // What the compiler made of it must still be right.
  check: () => checkAll(subject, measured, cases, answers),
};
process.on('message', (message) => process.send({ [message]: does[message]() }));
process.send({ started: true });

/** Runs until the compiler has settled, and finds out how many rounds over the inputs fill a sample. */
function warmUp() {
  const end = performance.now() + WARM_UP_MS;
  for (;;) {
    const taken = timed();
    if (performance.now() >= end) {
      rounds = Math.max(1, Math.round((rounds * SAMPLE_MS) / taken));
      return true;
    }
    if (taken < SAMPLE_MS / 2) rounds *= 2;
  }
}

/** Milliseconds for the rounds over the inputs. */
function timed() {
  const begin = performance.now();
  for (let round = 0; round < rounds; round++) {
    for (let i = 0; i < inputs.length; i++) answers[i] = run(inputs[i]);
  }
  return performance.now() - begin;
}
