import assert from 'node:assert/strict';
import { pduOf } from './frames.mjs';

/** Throws unless each answer is right: a program that is fast and wrong is not measured. */
export function checkAll({ answers: kind, title }, measured, cases, answers) {
  cases.forEach(({ answer: expected }, i) => {
    const got = answers[i];
    const message = `${title}: answer ${i} is wrong`;
    if (kind === 'checksum') assert.equal(got, expected, message);
    else if (kind === 'frame') assertBytes(got, measured.pduOnly ? pduOf(expected) : expected, message);
    else assert.deepEqual(Array.from(measured.registers(got)), expected, message);
  });
}

/** Compares bytes whether they are a Buffer or a plain Uint8Array. */
function assertBytes(got, expected, message) {
  assert.ok(got instanceof Uint8Array, message);
  assert.equal(Buffer.from(got).toString('hex'), Buffer.from(expected).toString('hex'), message);
}
