// `npm run bench:stream`: how well and how fast a stream without times is split into its frames. The peer is the sniffer of
// modbus-connector from PyPI; it needs Python, and `pip install modbus-connector`, wherever PYTHONPATH finds it.
import { spawnSync } from 'node:child_process';
import { cpus } from 'node:os';
import { fileURLToPath } from 'node:url';
import { runScript } from '../scripts/run.mjs';
import { Random } from './random.mjs';
import { score } from './score.mjs';
import { damage, traffic } from './traffic.mjs';

const PAIRS = 10_000;
const SEEDS = 3;
const ROUNDS = 100;
const TARGETS = { found: 0.999, false: 10, right: 0.99, speed: 40, clean: 0.25, damaged: 1 };
/** The functions the peer knows. */
const COMMON = [1, 2, 3, 4, 5, 6, 15, 16];
const STREAMS = [
  { title: 'all functions, clean', share: 0 },
  { title: 'all functions, 1 % of bytes changed and 1 % dropped', share: 0.01 },
  { title: '01–06, 0F and 10, 1 % of bytes changed and 1 % dropped', share: 0.01, codes: COMMON },
];

if ((await runScript('build:lib')) !== 0) process.exit(1);
const { encodeFrame, splitStream } = await import('../dist/lib/framewright.js');
const { greedy } = await import('./greedy.mjs');

const script = fileURLToPath(new URL('peers/modbus_connector_stream.py', import.meta.url));
const peer = (bytes) => {
  const { status, stdout } = spawnSync('python3', [script], { input: bytes, maxBuffer: 2 ** 28 });
  return status === 0 ? JSON.parse(stdout) : undefined;
};

/** Rounds in turns, and how often each stream is split in one. */
const TURNS = 25;
const IN_TURN = 4;
const milliseconds = () => (({ user, system }) => (user + system) / 1000)(process.cpuUsage());

/** How fast we are in turns with the plain greedy scan, as a share of its speed: the median of processor times. */
function shareOfGreedy(bytes) {
  const timeOf = (split) => {
    const begin = milliseconds();
    for (let i = 0; i < IN_TURN; i++) split(bytes);
    return milliseconds() - begin;
  };
  const shares = Array.from({ length: TURNS }, () => timeOf(greedy) / timeOf(splitStream));
  return shares.sort((a, b) => a - b)[TURNS >> 1] ?? 0;
}

/** The speed in MB/s in the fastest round, which what else the machine does disturbs least. */
function speedOf(bytes) {
  let least = Number.POSITIVE_INFINITY;
  for (let round = 0; round < ROUNDS; round++) {
    const begin = performance.now();
    splitStream(bytes);
    least = Math.min(least, performance.now() - begin);
  }
  return bytes.length / 1000 / least;
}

const percent = (share) => `${(100 * share).toFixed(2)} %`;
const columns = (...cells) =>
  console.log(cells.map((cell, i) => String(cell)[i === 0 ? 'padEnd' : 'padStart'](i === 0 ? 22 : 13)).join(''));
const row = (name, { intact, found, tellable, right, wrong, false: never }, speed) =>
  columns(
    name,
    intact,
    percent(found / intact),
    never,
    percent(right / tellable),
    wrong,
    speed < 10 ? speed.toFixed(2) : speed.toFixed(0),
  );

console.log(
  `\nNode ${process.version} on ${cpus()[0]?.model.trim() ?? 'an unknown processor'}; ${PAIRS} pairs a stream`,
);
const random = new Random();
let met = true;
let absent = false;
for (const { title, share, codes } of STREAMS) {
  console.log(`\n${title}`);
  columns('', 'intact', 'found', 'never sent', 'direction', 'wrong', 'MB/s');
  for (let seed = 0; seed < SEEDS; seed++) {
    const { bytes, frames } = damage(random, traffic(random, encodeFrame, PAIRS, codes), share, share);
    const ours = score(
      splitStream(bytes).filter(({ kind }) => kind === 'frame'),
      frames,
    );
    const speed = speedOf(bytes);
    row(`framewright, ${(bytes.length / 1e6).toFixed(2)} MB`, ours, speed);
    const ofGreedy = shareOfGreedy(bytes);
    console.log(`  of the speed of a plain greedy scan, in turns: ${ofGreedy.toFixed(2)}`);
    met &&= ofGreedy >= (share === 0 ? TARGETS.clean : TARGETS.damaged);
    met &&=
      ours.found >= TARGETS.found * ours.intact &&
      ours.false <= TARGETS.false &&
      ours.right >= TARGETS.right * ours.tellable &&
      speed >= TARGETS.speed;
    if (codes === undefined) continue;
    const theirs = peer(bytes);
    absent ||= theirs === undefined;
    if (theirs !== undefined) row('modbus-connector', score(theirs.found, frames), bytes.length / 1e6 / theirs.seconds);
  }
}
if (absent) {
  console.log('\n!!! modbus-connector IS ABSENT: its rows are missing. `pip install modbus-connector`, for python3.');
}
console.log(
  `\nTargets: found ${percent(TARGETS.found)}, never sent ${TARGETS.false}, direction ${percent(TARGETS.right)},`,
);
console.log(`${TARGETS.speed} MB/s (fastest of ${ROUNDS} rounds): ${met ? 'met' : 'NOT ALL MET'}`);
