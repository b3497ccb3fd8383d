// `npm run bench:maps -- FOLDER`: of the register maps in a folder, how many rows are read without a question, how many with one,
// and how many not at all; and whether the checked rows of public maps are right. Files by others are not in this project.
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { runScript } from '../scripts/run.mjs';
import { known } from './maps/known.mjs';

const [folder] = process.argv.slice(2);
if (folder === undefined) {
  console.error('Name a folder with register maps.');
  process.exit(1);
}
if (process.env.BUILT === undefined && (await runScript('build:lib')) !== 0) process.exit(1);
const { namedValues, readRegisterMap } = await import('../dist/lib/framewright.js');

const RAW = 490;

/** Whether a register is as it must be; its factor is told by what a raw number becomes. */
function isRight(profile, expected) {
  return profile.registers.some((register) => {
    const { factor, scaleRegister, ...facts } = expected;
    if (Object.entries(facts).some(([key, value]) => register[key] !== value)) return false;
    if (scaleRegister !== undefined) return register.scaleRegister?.address === scaleRegister;
    if (factor === undefined || register.type === 'f32') return true;
    const words = { u16: [RAW], i16: [RAW] }[register.type] ?? [0, RAW];
    const { scaled } =
      namedValues({ ...profile, registers: [register] }, register.table, register.address, words)[0] ?? {};
    return Math.abs(Number(scaled) - RAW * factor) < 1e-9 * RAW;
  });
}

const rowsOf = (told) => new Set(told.flatMap(({ rows }) => rows));
const table = [];
for (const file of readdirSync(folder).sort()) {
  const bytes = new Uint8Array(readFileSync(join(folder, file)));
  const start = performance.now();
  const read = readRegisterMap(bytes, { name: file });
  const time = performance.now() - start;
  const { profile, questions, faults, notices } = read;
  const asked = rowsOf(notices.filter(({ code }) => code === 'assumed')).size;
  const lost = rowsOf(faults).size;
  const facts = known.find((one) => one.file.test(file));
  const answered = facts?.answers ? readRegisterMap(bytes, { name: file, answers: facts.answers }) : read;
  const right = facts?.checked.filter((one) => isRight(answered.profile, one)).length;
  const never = facts?.never === undefined ? 0 : answered.profile.registers.filter(facts.never).length;
  table.push({
    file,
    registers: profile.registers.length,
    expected: facts?.rows ?? '',
    unasked: Math.max(0, profile.registers.length - asked),
    asked: Math.min(asked, profile.registers.length),
    lost,
    questions: questions.map(({ code }) => code).join(', '),
    answers: Object.keys(facts?.answers ?? {}).join(', '),
    checked: right === undefined ? '' : `${right} of ${facts.checked.length}${never > 0 ? `, ${never} wrong` : ''}`,
    ms: Math.round(time),
  });
}
console.table(table);
