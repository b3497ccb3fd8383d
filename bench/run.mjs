// `npm run bench`: how fast the library is, and by how much faster than others that do the same work.
// Each program does each subject in a process of its own, so that none runs in code that was compiled for another's
// inputs. At any time one of them works and the others wait; they take turns every few milliseconds, so that whatever
// else the machine does falls on them all.
import { cpus } from 'node:os';
import { runScript } from '../scripts/run.mjs';
import { Contestant } from './contestant.mjs';
import { loadPeer, programs } from './peers.mjs';
import { report } from './report.mjs';
import { subjects } from './subjects.mjs';

/** Compilers do not come to the same code every time: more than one process a program. */
const PROCESSES = 3;
const SAMPLES = 9;

// `npm run bench -- decode` measures what has "decode" in its name.
const wanted = process.argv.slice(2);
const chosen = subjects.filter(({ id }) => wanted.length === 0 || wanted.some((part) => id.includes(part)));

if ((await runScript('build:lib')) !== 0) process.exit(1);

const peers = await Promise.all(programs.map(async (program) => ({ program, ways: await loadPeer(program) })));
/** @type {import('./report.mjs').Row[][]} */
const tables = chosen.map((subject) =>
  peers
    .filter(({ ways }) => ways[subject.measure] !== undefined)
    .map(({ program, ways }) => ({ subject, program, note: ways[subject.measure].note, speeds: [] })),
);

for (let i = 0; i < PROCESSES; i++) {
  for (const table of tables) await compete(table);
}

console.log(`\nNode ${process.version} on ${cpus()[0]?.model.trim() ?? 'an unknown processor'}`);
console.log(
  `Medians of ${PROCESSES * SAMPLES} runs in ${PROCESSES} processes; four of five runs lie between "from" and "to".`,
);
console.log('"Undisturbed" is the ratio of the fastest tenths: what else the machine does matters least there.');
for (const line of report(tables)) console.log(line);

/** @param {import('./report.mjs').Row[]} rows of one subject */
async function compete(rows) {
  const contestants = rows.map((row) => new Contestant(row));
  await Promise.all(contestants.map((contestant) => contestant.started()));
  for (const contestant of contestants) await contestant.warmUp();
  for (let i = 0; i < SAMPLES; i++) {
    // Back and forth, so that no program always follows the same one.
    for (const contestant of i % 2 === 0 ? contestants : contestants.toReversed()) await contestant.sample();
  }
  for (const contestant of contestants) await contestant.finish();
}
